# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Points with whatever was measured at them."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _bridge, _html
from ._arrays import Floats, vectors
from .layout import FieldValues, FileLayout, Lists

if TYPE_CHECKING:
    import pandas as pd

_COORDINATES = ("x", "y", "z")
_NORMALS = ("nx", "ny", "nz")


@dataclass(eq=False, repr=False)
class PointCloud:
    """Points with whatever was measured at them, as a file holds them.

    Parameters
    ----------
    points : array (N, 3)
        Coordinates in any unit; becomes float64.
    normals : array (N, 3), optional
        One unit vector per point, zero where there is none; becomes float64.
    fields : dict of str to array (N,), array (N, K) or Lists
        Anything else known of each point. Integers, float32 and float64 keep their type, bool
        becomes uint8, float16 becomes float32; an array (N, K) becomes Lists.
    layout : FileLayout
        What a file says beyond its points, such as comments, faces and the coordinate system.

    Raises
    ------
    ValueError
        For an array of another shape, or with another number of points.
    """

    points: Floats
    normals: Floats | None = None
    fields: dict[str, FieldValues] = field(default_factory=dict)
    layout: FileLayout = field(default_factory=FileLayout)

    def __post_init__(self) -> None:
        self.points = vectors("points", self.points)
        if self.normals is not None:
            self.normals = vectors("normals", self.normals)
            self._require_size("normals", self.normals)
        self.fields = {
            name: _bridge.field_values(name, value) for name, value in self.fields.items()
        }
        for name, value in self.fields.items():
            self._require_size(f"field '{name}'", value)

    def _require_size(self, what: str, value: FieldValues) -> None:
        if len(value) != len(self):
            raise ValueError(
                f"{what} must have one entry per point ({len(self)}), got {len(value)}"
            )

    def __len__(self) -> int:
        return len(self.points)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        if copy is None:
            return np.asarray(self.points, dtype=dtype)
        return np.array(self.points, dtype=dtype, copy=copy)

    def __getitem__(self, name: str) -> FieldValues:
        if not isinstance(name, str):
            raise TypeError(f"a cloud has fields by name, got {name!r}: take() chooses points")
        if name in self.fields:
            return self.fields[name]
        if name in _COORDINATES:
            return self.points[:, _COORDINATES.index(name)]
        if name in _NORMALS and self.normals is not None:
            return self.normals[:, _NORMALS.index(name)]
        raise KeyError(f"no field '{name}', there are {' '.join(self.names)}")

    @property
    def names(self) -> list[str]:
        """Names of all columns: x y z, nx ny nz where there are normals, then the fields."""
        normals = _NORMALS if self.normals is not None else ()
        return [*_COORDINATES, *normals, *self.fields]

    def take(self, which: ArrayLike) -> PointCloud:
        """Some of the points with all that belongs to them.

        Parameters
        ----------
        which : array of bool (N,), or of indices (M,)

        Returns
        -------
        PointCloud
            Owns its arrays. Elements of the layout, such as faces, are left out, since they may
            refer to points that are gone.
        """
        chosen: NDArray[Any] = np.asarray(which)
        if chosen.dtype == np.bool_ and chosen.shape != (len(self),):
            raise ValueError(f"which must have shape ({len(self)},), got {chosen.shape}")
        indices = np.arange(len(self))[chosen]
        return PointCloud(
            self.points[indices],
            None if self.normals is None else self.normals[indices],
            {
                name: value.take(indices) if isinstance(value, Lists) else value[indices]
                for name, value in self.fields.items()
            },
            dataclasses.replace(self.layout, elements=[]),
        )

    def to_structured(self) -> NDArray[np.void]:
        """All columns as one structured array (N,); lists have the type object."""
        columns = {name: self[name] for name in self.names}
        array = np.empty(
            len(self),
            dtype=[
                (name, object if isinstance(value, Lists) else value.dtype)
                for name, value in columns.items()
            ],
        )
        for name, value in columns.items():
            if isinstance(value, Lists):
                array[name] = np.fromiter(value, dtype=object, count=len(value))
            else:
                array[name] = value
        return array

    @classmethod
    def from_structured(cls, array: NDArray[np.void]) -> PointCloud:
        """A cloud of a structured array with x, y and z; nx, ny and nz are normals.

        Raises
        ------
        ValueError
            For an array without one of x, y and z.
        """
        names = array.dtype.names or ()
        return cls._from_columns({name: array[name] for name in names})

    def to_dataframe(self) -> pd.DataFrame:
        """All columns as a pandas.DataFrame; needs pandas (`pip install deburr[pandas]`)."""
        import pandas as pd

        frame: pd.DataFrame = pd.DataFrame(
            {
                name: [*value] if isinstance(value, Lists) else value
                for name, value in ((name, self[name]) for name in self.names)
            }
        )
        return frame

    @classmethod
    def from_dataframe(cls, frame: pd.DataFrame) -> PointCloud:
        """A cloud of a pandas.DataFrame with x, y and z; nx, ny and nz are normals.

        Raises
        ------
        ValueError
            For a frame without one of x, y and z.
        """
        return cls._from_columns({str(name): frame[name].to_numpy() for name in frame.columns})

    @classmethod
    def _from_columns(cls, columns: dict[str, NDArray[Any]]) -> PointCloud:
        def take_out(names: tuple[str, ...]) -> Floats:
            return np.stack([columns.pop(name).astype(np.float64) for name in names], axis=1)

        absent = [name for name in _COORDINATES if name not in columns]
        if absent:
            raise ValueError(f"x, y and z are needed, got {' '.join(columns)}")
        points = take_out(_COORDINATES)
        normals = take_out(_NORMALS) if all(name in columns for name in _NORMALS) else None
        return cls(points, normals, {name: _lists_or(array) for name, array in columns.items()})

    def equals(self, other: PointCloud) -> bool:
        """Whether everything is the same to the last bit; NaN equals NaN."""
        return _same(self, other)

    def __repr__(self) -> str:
        return f"PointCloud({len(self)} points: {' '.join(self.names)})"

    def _repr_html_(self) -> str:
        rows = [(name, *_html.column(self[name])) for name in self.names]
        return _html.table(f"{len(self)} points", ("field", "type", "least", "most"), rows)


def _lists_or(array: NDArray[Any]) -> FieldValues:
    """The lists of an array of arrays, which is how tables hold them."""
    if array.dtype != object or not all(isinstance(item, np.ndarray) for item in array):
        return array
    if not len(array):
        return array
    return Lists(np.concatenate([*array]), np.cumsum([0, *(len(item) for item in array)]))


def _same(a: Any, b: Any) -> bool:
    if type(a) is not type(b):
        return False
    if isinstance(a, np.ndarray):
        if a.dtype != b.dtype:
            return False
        return bool(np.array_equal(a, b, equal_nan=a.dtype.kind == "f"))
    if isinstance(a, dict):
        return [*a] == [*b] and all(_same(a[name], b[name]) for name in a)
    if isinstance(a, (list, tuple)):
        return len(a) == len(b) and all(map(_same, a, b))
    if hasattr(a, "__dict__"):
        return _same(vars(a), vars(b))
    return bool(a == b)

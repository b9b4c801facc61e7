# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What a file says beyond its points."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import values as exact


class Lists:
    """A list of values for each point, such as the corners of each face.

    Item i holds values[offsets[i]:offsets[i + 1]].

    Parameters
    ----------
    values : array (M,) of integers, float32 or float64
    offsets : array (N + 1,) of integers
        Ascending from 0 to M.
    length_type : str
        Type that the lengths have in a file, such as "uint8".
    """

    def __init__(self, values: ArrayLike, offsets: ArrayLike, length_type: str = "uint8") -> None:
        self.values: NDArray[Any] = np.ascontiguousarray(values)
        self.offsets: NDArray[np.uint64] = exact("offsets", offsets, np.uint64)
        self.length_type = length_type
        ends = self.offsets.astype(np.int64)
        if self.values.ndim != 1:
            raise ValueError(f"values must have shape (M,), got {self.values.shape}")
        if ends.size == 0 or ends[0] != 0 or ends[-1] != self.values.size or (ends < 0).any():
            raise ValueError(f"offsets must go from 0 to {self.values.size}")
        if (np.diff(ends) < 0).any():
            raise ValueError("offsets must ascend")

    @classmethod
    def of_rows(cls, rows: ArrayLike) -> Lists:
        """One list for each row of a (N, K) array."""
        table: NDArray[Any] = np.ascontiguousarray(rows)
        if table.ndim != 2:
            raise ValueError(f"rows must have shape (N, K), got {table.shape}")
        return cls(table.ravel(), np.arange(len(table) + 1) * table.shape[1])

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def __getitem__(self, i: int) -> NDArray[Any]:
        at = range(len(self))[i]
        return self.values[int(self.offsets[at]) : int(self.offsets[at + 1])]

    def __iter__(self) -> Iterator[NDArray[Any]]:
        return (self[i] for i in range(len(self)))

    def take(self, indices: NDArray[np.intp]) -> Lists:
        """The lists of some items."""
        chosen = [self[i] for i in indices.tolist()]
        ends = np.cumsum([0, *(len(values) for values in chosen)])
        joined = np.concatenate(chosen) if chosen else self.values[:0]
        return Lists(joined, ends, self.length_type)

    def __repr__(self) -> str:
        return f"Lists({len(self)} lists of {self.values.dtype}, {self.values.size} values)"


#: What a field can hold: an array (N,), of numbers or of str (dtype object), or lists.
FieldValues = NDArray[Any] | Lists


class Field(NamedTuple):
    """Name and type of one field where it stands in a file."""

    name: str
    #: A name that NumPy has, such as "float32", or "str".
    type: str


class HeaderBlock(NamedTuple):
    """A part of a file that only its own format understands; kept as it is."""

    #: The format first: "LAS record LASF_Projection 34735".
    name: str
    data: bytes

    def __repr__(self) -> str:
        return f"HeaderBlock({self.name!r}, {len(self.data)} bytes)"


@dataclass(eq=False)
class Element:
    """Anything in a file that is not about points, such as the faces of a mesh."""

    name: str
    size: int
    fields: dict[str, FieldValues]
    #: Whether it stands before the points in the file.
    before_points: bool = False


@dataclass(eq=False)
class FileLayout:
    """What a file says beyond its points, kept so that writing it back changes nothing else."""

    #: "none" for a cloud that does not come from a file, else such as "ply-little-endian", "las".
    encoding: str = "none"
    #: Of a text file, between columns.
    separator: str = " "
    #: "none", "plain" (a line of names) or "marked" (behind a comment mark).
    header: str = "none"
    #: What a comment of a text file starts with.
    mark: str = "#"
    #: Whether the number of points stands in the first line of a text file.
    count_line: bool = False
    #: Of the points, in file order, coordinates among them.
    fields: list[Field] = field(default_factory=list)
    comments: list[str] = field(default_factory=list)
    #: The comments that PLY marks so.
    obj_info: list[str] = field(default_factory=list)
    elements: list[Element] = field(default_factory=list)
    blocks: list[HeaderBlock] = field(default_factory=list)
    #: Length by which coordinates have to be told apart where a format rounds them to a grid (LAS):
    #: the grid of the file is refined to it. 0 keeps the grid.
    resolution: float = 0.0

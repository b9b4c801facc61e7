# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What denoise() gives back."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _html
from ._arrays import Bytes, Floats, Mask, Points, vectors
from ._foreign import Given
from .cloud import PointCloud
from .report import Report

if TYPE_CHECKING:
    from .viewing import Page

#: What to_cloud() can add for every point.
ADDABLE = ("normals", "label", "displacement", "outlier")


@dataclass(frozen=True, eq=False, repr=False)
class Result:
    """The clean points and what is known of them.

    Arrays own their memory and are in the order of the input; outliers that are removed
    (`outliers="remove"`) are in none of them.
    """

    #: (N, 3), the moved points: float64, or float32 if the input was and float32 is fine enough
    #: (its step no more than 1e-5 of the diagonal of the bounding box).
    points: Points
    #: (N, 3) float64, unit normals; zero where there is none.
    normals: Floats
    #: (N,) uint8, what each point lies on: see Feature.
    labels: Bytes
    #: (N,) bool, points that are no part of the surface.
    outliers: Mask
    #: (N,) float64, distance that each point moved, in the unit of the input.
    displacement: Floats
    report: Report
    #: (N,) uint64, the index of each point in the input; None where all are kept.
    kept: NDArray[np.uint64] | None = None
    _given: Given | None = None

    def __len__(self) -> int:
        return len(self.points)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        if copy is None:
            return np.asarray(self.points, dtype=dtype)
        return np.array(self.points, dtype=dtype, copy=copy)

    @property
    def max_displacement(self) -> float:
        """The largest displacement."""
        return float(self.displacement.max(initial=0.0))

    @property
    def rms_displacement(self) -> float:
        """Root mean square of the displacements of finite points."""
        largest = self.max_displacement
        if not largest > 0:
            return 0.0
        if len(self) == self.report.kept:
            finite = self.report.points - self.report.non_finite
        else:  # a part
            finite = int(np.isfinite(self.points).all(axis=1).sum())
        # Relative to the largest, no square can overflow.
        return largest * float(np.sqrt(np.square(self.displacement / largest).sum() / finite))

    def to_cloud(self, add: Collection[str] = ADDABLE) -> PointCloud:
        """The clean points with everything that came with them, ready to be written.

        Parameters
        ----------
        add : str or collection of str
            What is added for every point: "normals", "label" (field deburr_label, uint8: see
            Feature), "displacement" (deburr_displacement, float32) and "outlier" (deburr_outlier,
            uint8). Normals that came in are replaced in any case.

        Returns
        -------
        PointCloud
            Fields and layout are those of the input where that was a PointCloud or was read as
            one; removing points leaves out the elements of the layout, such as faces.
        """
        add = [add] if isinstance(add, str) else [*add]
        for word in add:
            if word not in ADDABLE:
                raise ValueError(f"add must be of {', '.join(ADDABLE)}, got '{word}'")
        source = self._given.cloud if self._given is not None else None
        cloud = PointCloud(vectors("points", self.points))
        if source is not None:
            source = source if self.kept is None else source.take(self.kept.astype(np.intp))
            cloud.fields = dict(source.fields)
            cloud.layout = dataclasses.replace(source.layout, resolution=self._resolution())
        had_normals = source is not None and source.normals is not None
        if "normals" in add or had_normals:
            cloud.normals = self.normals
        if "label" in add:
            cloud.fields["deburr_label"] = self.labels
        if "displacement" in add:
            most = float(np.finfo(np.float32).max)
            cloud.fields["deburr_displacement"] = np.minimum(self.displacement, most).astype("f4")
        if "outlier" in add:
            cloud.fields["deburr_outlier"] = self.outliers.astype(np.uint8)
        new_columns = [*add] if not had_normals else [word for word in add if word != "normals"]
        if new_columns and cloud.layout.header == "none":
            # Only a header can tell what a new column of a text file is.
            cloud.layout = dataclasses.replace(cloud.layout, header="plain")
        return cloud

    def part(self, which: ArrayLike | slice, of: PointCloud | None = None) -> Result:
        """The result for some of the points, such as those of one tile among its neighbours.

        Parameters
        ----------
        which : slice, array of bool (N,), or of indices (M,)
        of : PointCloud, optional
            What these points came from, whose fields and layout the part takes over; one entry
            per point of the part.

        Returns
        -------
        Result
            The report stays that of the whole.

        Raises
        ------
        ValueError
            If `of` has another number of points.
        """
        chosen = which if isinstance(which, slice) else np.asarray(which)
        points = self.points[chosen]
        if of is not None and len(of) != len(points):
            raise ValueError(f"of must have one entry per point ({len(points)}), got {len(of)}")
        cloud = of
        if of is None and self._given is not None and self._given.cloud is not None:
            source = self._given.cloud
            at = np.arange(len(source)) if self.kept is None else self.kept.astype(np.intp)
            cloud = source.take(at[chosen])
        return Result(
            points=points,
            normals=self.normals[chosen],
            labels=self.labels[chosen],
            outliers=self.outliers[chosen],
            displacement=self.displacement[chosen],
            report=self.report,
            _given=None if cloud is None else Given(cloud.points, cloud.normals, cloud),
        )

    def _resolution(self) -> float:
        """A grid has to tell apart what the movement did, but nothing far below the spacing."""
        moved = self.rms_displacement
        return max(moved / 32, 1e-4 * self.report.spacing) if moved > 0 else 0.0

    def as_given(self) -> Any:
        """The clean points as an object of the kind that was given to denoise().

        Returns
        -------
        object
            An Open3D cloud (legacy or tensor), a laspy.LasData, a PyVista mesh or a PointCloud,
            with all that the input had; an array for anything else. What the kind can hold is
            added: normals, deburr_label, deburr_displacement, deburr_outlier.
        """
        return self.points if self._given is None else self._given.give_back(self)

    def view(self, *, truth: Any = None, height: int = 640, max_size: float = 12.0) -> Page:
        """Show the points before and after, in Jupyter or as a file: as deburr.view() does."""
        from .viewing import view

        return view(self, truth=truth, height=height, max_size=max_size)

    def save_report(
        self,
        path: str | os.PathLike[str],
        *,
        names: Sequence[str] = ("before", "after"),
        truth: Any = None,
        max_size: float = 12.0,
    ) -> None:
        """Write what `deburr denoise --report` writes, whole or not at all.

        Parameters
        ----------
        path : str or path
            Ending in .html or .htm, a page that shows the points before and after with the report;
            with any other name the report as JSON. "-" is the standard output.
        names : (str, str)
            What the points are called before and after, such as their files.
        truth, max_size
            Of the page, as of view().

        Raises
        ------
        DeburrIOError
            If the file cannot be written.
        ValueError, RuntimeError
            As view().
        """
        from . import _summary
        from .viewing import view

        if Path(path).suffix.lower() in (".html", ".htm"):
            view(self, names=names, truth=truth, max_size=max_size).save(path)
            return
        _summary.write(path, self, names)

    def __getstate__(self) -> dict[str, Any]:
        given = self._given.without_original() if self._given is not None else None
        return {**self.__dict__, "_given": given}

    def __repr__(self) -> str:
        r = self.report
        return (
            f"Result({len(self)} points, noise {r.noise:.6g}, spacing {r.spacing:.6g}, "
            f"{r.outliers} outliers, moved by {self.rms_displacement:.6g} (rms), "
            f"at most {self.max_displacement:.6g})"
        )

    def _repr_html_(self) -> str:
        moved = f"{self.rms_displacement:.6g} (rms), at most {self.max_displacement:.6g}"
        return _html.table("deburr", (), [*self.report.rows(), ("moved by", moved)])

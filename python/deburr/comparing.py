# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""compare(): all figures at once, as the program `deburr compare` gives them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _html, metrics
from ._clouds import cloud_of
from .cloud import PointCloud
from .figures import DistanceError, FeatureScore, NormalError, OffsetError, OutlierScore
from .mesh import TriangleMesh
from .result import Result
from .synthetic import SyntheticScan

#: Offsets are called far from this many spacings on.
_FAR = 1.5


@dataclass(frozen=True)
class Comparison:
    """How a cloud differs from the truth; what cannot be told is None. Lengths in its unit."""

    #: Points compared, those that are not finite among them.
    points: int
    #: From the points to the truth.
    error: DistanceError
    #: From the truth to the points.
    coverage: DistanceError | None = None
    #: Where the truth is a cloud.
    chamfer: float | None = None
    #: Of the finite points on the true surface.
    spacing: float | None = None
    normals: NormalError | None = None
    #: Of the points near a sharp edge.
    edge_zone: DistanceError | None = None
    #: Where the cloud has labels.
    features: FeatureScore | None = None
    #: Where true outliers are known and the cloud has flags.
    outliers: OutlierScore | None = None
    #: Where the places without noise are known.
    offsets: OffsetError | None = None

    def _repr_html_(self) -> str:
        rows = []
        for name, value in vars(self).items():
            parts = {"": value} if value is None or isinstance(value, (int, float)) else vars(value)
            rows += [
                (f"{name} {part}".strip(), f"{number:.6g}")
                for part, number in parts.items()
                if number is not None
            ]
        return _html.table("comparison", (), rows)


def compare(
    cloud: ArrayLike | PointCloud | Result | Any,
    truth: TriangleMesh | PointCloud | SyntheticScan | ArrayLike,
    *,
    clean: PointCloud | None = None,
    threads: int = 0,
) -> Comparison:
    """Compare a cloud with the truth: distances, coverage, normals, labels.

    Parameters
    ----------
    cloud : Result, PointCloud, array (N, 3), or whatever denoise() takes
        Labels and outliers are those of a Result, or the fields deburr_label and deburr_outlier.
    truth : TriangleMesh, PointCloud, array (M, 3) or SyntheticScan
        A true cloud makes all distances grow with its spacing. Of a SyntheticScan, the surface,
        and the clean points where none are given and as many as in the cloud.
    clean : PointCloud, optional
        The same points without noise, in the same order, with their true normals; its field
        `outlier` tells the true outliers. Only with a surface is a far offset told from others.
    threads : int, 0 to 256

    Returns
    -------
    Comparison
        Without a finite point error.count is 0 and nothing else is measured.

    Raises
    ------
    ValueError
        If `clean` has another number of points, or for a mesh without triangles.
    """
    given = cloud_of(cloud)
    if isinstance(truth, SyntheticScan):
        if clean is None and len(truth.clean) == len(given):
            fields = {"outlier": truth.outliers.view(np.uint8)}
            clean = PointCloud(truth.clean, truth.normals, dict(fields))
        truth = truth.truth
    if isinstance(truth, TriangleMesh):
        figures = _to_surface(given, truth, threads)
    else:
        figures = _to_cloud(given, cloud_of(truth), threads)
    if clean is not None:
        figures.update(_to_clean(given, clean, figures.get("spacing")))
    return Comparison(points=len(given), **figures)


def _numbers(cloud: PointCloud, name: str) -> NDArray[Any] | None:
    value = cloud.fields.get(name)
    return value if isinstance(value, np.ndarray) and value.dtype.kind in "iuf" else None


def _labels(cloud: PointCloud) -> NDArray[np.uint8] | None:
    numbers = _numbers(cloud, "deburr_label")
    if numbers is None:
        return None
    return np.where((numbers >= 0) & (numbers <= 3), numbers, 0).astype(np.uint8)


def _to_surface(cloud: PointCloud, surface: TriangleMesh, threads: int) -> dict[str, Any]:
    points = cloud.points
    error = metrics.compare_to_surface(points, surface, threads=threads)
    figures: dict[str, Any] = {"error": error}
    if error.count == 0:
        return figures
    figures["coverage"] = metrics.surface_coverage(points, surface, threads=threads)
    if cloud.normals is not None:
        figures["normals"] = metrics.normal_error(points, cloud.normals, surface, threads=threads)
    spacing = metrics.mean_spacing(surface, error.count)
    if not spacing > 0:
        return figures
    figures["spacing"] = spacing
    sharp = metrics.find_sharp_features(surface)
    if len(sharp.edges):
        figures["edge_zone"] = metrics.edge_error(points, surface, sharp, spacing, threads=threads)
        labels = _labels(cloud)
        if labels is not None:
            figures["features"] = metrics.score_features(
                points, labels, sharp, spacing, threads=threads
            )
    return figures


def _to_cloud(cloud: PointCloud, truth: PointCloud, threads: int) -> dict[str, Any]:
    found = metrics.compare_to_cloud(cloud.points, truth.points, threads=threads)
    figures: dict[str, Any] = {"error": found.to_truth}
    if found.to_truth.count == 0:
        return figures
    figures.update(coverage=found.coverage, chamfer=found.chamfer)
    if cloud.normals is not None and truth.normals is not None:
        figures["normals"] = metrics.normal_error(
            cloud.points, cloud.normals, truth, threads=threads
        )
    return figures


def _to_clean(cloud: PointCloud, clean: PointCloud, spacing: float | None) -> dict[str, Any]:
    if len(clean) != len(cloud):
        raise ValueError(f"clean must have one entry per point ({len(cloud)}), got {len(clean)}")
    figures: dict[str, Any] = {}
    outliers = _numbers(clean, "outlier")
    flags = _numbers(cloud, "deburr_outlier")
    if outliers is not None and flags is not None:
        figures["outliers"] = metrics.score_outliers(flags, outliers)
    if clean.normals is not None:
        normals = clean.normals
        if outliers is not None:
            # An outlier has no place without noise.
            normals = np.where((outliers != 0)[:, np.newaxis], 0.0, normals)
        far = math.inf if spacing is None else _FAR * spacing
        figures["offsets"] = metrics.offset_error(cloud.points, clean.points, normals, far)
    return figures

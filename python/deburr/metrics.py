# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""How far a cloud is from what is known to be true, one function per figure."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Floats, real, values, vectors, whole
from .cloud import PointCloud
from .figures import (
    CloudError,
    DistanceError,
    FeatureScore,
    NormalError,
    OffsetError,
    OutlierScore,
    SharpFeatures,
)
from .mesh import TriangleMesh, arrays_of


def distance_to_surface(points: ArrayLike, surface: TriangleMesh, *, threads: int = 0) -> Floats:
    """Distance of every point to the nearest point of a surface, exact up to rounding.

    Returns
    -------
    array (N,) float64
        In the unit of the points; NaN for a point that is not finite.

    Raises
    ------
    ValueError
        For a mesh without triangles or with a corner that is not finite.
    """
    return _core.distance_to_surface(
        vectors("points", points), *arrays_of("surface", surface), whole("threads", threads)
    )


def distance_to_cloud(points: ArrayLike, cloud: ArrayLike, *, threads: int = 0) -> Floats:
    """Distance of every point to the nearest finite point of another cloud.

    Returns
    -------
    array (N,) float64
        In the unit of the points; NaN for a point that is not finite, and everywhere where the
        other cloud has no finite point.
    """
    return _core.distance_to_cloud(
        vectors("points", points), vectors("cloud", cloud), whole("threads", threads)
    )


def compare_to_surface(
    points: ArrayLike, surface: TriangleMesh, *, threads: int = 0
) -> DistanceError:
    """Summarise distance_to_surface() over all finite points."""
    return DistanceError(
        *_core.compare_to_surface(
            vectors("points", points), *arrays_of("surface", surface), whole("threads", threads)
        )
    )


def compare_to_cloud(points: ArrayLike, truth: ArrayLike, *, threads: int = 0) -> CloudError:
    """Compare points with the true cloud; those that are not finite are left out.

    The distances grow with the spacing of the truth, even for points on the true surface: compare
    only clouds that were measured against the same truth.
    """
    to_truth, coverage, chamfer = _core.compare_to_cloud(
        vectors("points", points), vectors("truth", truth), whole("threads", threads)
    )
    return CloudError(DistanceError(*to_truth), DistanceError(*coverage), chamfer)


def surface_coverage(
    points: ArrayLike,
    surface: TriangleMesh,
    *,
    samples: int = 100000,
    seed: int = 1,
    threads: int = 0,
) -> DistanceError:
    """How far places of a surface lie from the nearest finite point.

    Parameters
    ----------
    points : array (N, 3)
    surface : TriangleMesh
    samples : int
        Places on the surface, uniform over its area; 0 for none.
    seed : int
        The same seed gives the same places.
    """
    return DistanceError(
        *_core.surface_coverage(
            vectors("points", points),
            *arrays_of("surface", surface),
            whole("samples", samples),
            whole("seed", seed),
            whole("threads", threads),
        )
    )


def mean_spacing(surface: TriangleMesh, count: int) -> float:
    """Mean spacing of so many points on a surface: sqrt(area / count), 0 for none."""
    return _core.mean_spacing(*arrays_of("surface", surface), whole("count", count))


def normal_error(
    points: ArrayLike,
    normals: ArrayLike,
    truth: TriangleMesh | PointCloud,
    *,
    threads: int = 0,
) -> NormalError:
    """Compare the normal of every point with that of the nearest triangle or true point.

    Of several at the same distance, as at edges, the one counts that agrees best. Left out are
    points that are not finite, and normals that are zero or not finite.

    Raises
    ------
    ValueError
        If sizes differ, or for a true cloud without normals.
    """
    at, of = vectors("points", points), vectors("normals", normals)
    if isinstance(truth, TriangleMesh):
        return NormalError(
            *_core.normal_error_to_surface(
                at, of, *arrays_of("truth", truth), whole("threads", threads)
            )
        )
    if truth.normals is None:
        raise ValueError("truth must have normals, got none")
    return NormalError(
        *_core.normal_error_to_cloud(at, of, truth.points, truth.normals, whole("threads", threads))
    )


def find_sharp_features(surface: TriangleMesh) -> SharpFeatures:
    """Find the edges at which faces meet at more than 30 degrees, and the corners of these."""
    return SharpFeatures(*_core.find_sharp_features(*arrays_of("surface", surface)))


def edge_error(
    points: ArrayLike,
    surface: TriangleMesh,
    sharp: SharpFeatures,
    spacing: float,
    *,
    threads: int = 0,
) -> DistanceError:
    """compare_to_surface() of the points within one spacing of a sharp edge."""
    return DistanceError(
        *_core.edge_error(
            vectors("points", points),
            *arrays_of("surface", surface),
            np.ascontiguousarray(sharp.edges, dtype=np.float64),
            vectors("corners", sharp.corners),
            real("spacing", spacing),
            whole("threads", threads),
        )
    )


def score_features(
    points: ArrayLike,
    labels: ArrayLike,
    sharp: SharpFeatures,
    spacing: float,
    *,
    threads: int = 0,
) -> FeatureScore:
    """Judge labels by where the points are now.

    Parameters
    ----------
    points : array (N, 3)
    labels : array (N,) of uint8
        See Feature.
    sharp : SharpFeatures
        Of the true surface.
    spacing : float
        Mean spacing of the points, > 0, in their unit; see mean_spacing().
    """
    return FeatureScore(
        *_core.score_features(
            vectors("points", points),
            values("labels", labels, np.uint8),
            np.ascontiguousarray(sharp.edges, dtype=np.float64),
            vectors("corners", sharp.corners),
            real("spacing", spacing),
            whole("threads", threads),
        )
    )


def score_outliers(flags: ArrayLike, truth: ArrayLike) -> OutlierScore:
    """Compare flags (N,) with the true ones; anything but 0 is a flag."""

    def bits(flags: ArrayLike) -> NDArray[np.uint8]:
        return np.ascontiguousarray(np.asarray(flags) != 0).view(np.uint8)

    return OutlierScore(*_core.score_outliers(bits(flags), bits(truth)))


def offset_error(
    points: ArrayLike, clean: ArrayLike, normals: ArrayLike, far: float
) -> OffsetError:
    """Compare points with the same ones without noise, along the true normals.

    Parameters
    ----------
    points, clean, normals : array (N, 3)
        In the same order. Left out are points that are not finite and normals that are zero.
    far : float
        Offsets larger than this count as far; > 0, infinite if of no interest.
    """
    return OffsetError(
        *_core.offset_error(
            vectors("points", points),
            vectors("clean", clean),
            vectors("normals", normals),
            real("far", far),
        )
    )

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""How far a cloud is from what is known to be true, one function per figure."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Floats, real, values, vectors, whole
from .cloud import PointCloud
from .mesh import TriangleMesh


@dataclass(frozen=True)
class DistanceError:
    """Distances to something true, summarised; lengths in the unit of the input."""

    mean: float
    rms: float
    #: The smallest distance that 95 % of all do not exceed.
    percentile_95: float
    maximum: float
    #: Of the bounding box of the truth, to make the above relative.
    diagonal: float
    #: Distances measured; where there are none, the first four are zero.
    count: int


@dataclass(frozen=True)
class CloudError:
    """How two clouds differ, of which one is true."""

    to_truth: DistanceError
    coverage: DistanceError
    #: Mean squared distances of both directions, added, of the clouds in a unit sphere, times 1e4;
    #: NaN where that is not defined.
    chamfer: float


@dataclass(frozen=True)
class NormalError:
    """Angles between normals and the true ones, in degrees."""

    #: Mean angle between the lines, 0 to 90.
    unoriented: float
    #: Mean angle between the directions, 0 to 180.
    oriented: float
    count: int


@dataclass(frozen=True)
class SharpFeatures:
    """Where a surface is sharp."""

    #: (E, 2, 3), both ends of each edge.
    edges: Floats
    #: (C, 3)
    corners: Floats


@dataclass(frozen=True)
class FeatureScore:
    """How well labels match the true sharp edges and corners; NaN where there is no share."""

    edge_precision: float
    edge_recall: float
    edge_point_recall: float
    corner_precision: float
    corner_recall: float
    edge_labels: int
    corner_labels: int


@dataclass(frozen=True)
class OutlierScore:
    """How well flags match the true outliers; NaN where there is nothing to take a share of."""

    precision: float
    recall: float
    flagged: int
    outliers: int


@dataclass(frozen=True)
class OffsetError:
    """How far points lie from their own places without noise, along the true normals."""

    mean: float
    rms: float
    far_share: float
    count: int


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
        vectors("points", points), surface.vertices, surface.triangles, whole("threads", threads)
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
            vectors("points", points), surface.vertices, surface.triangles, threads
        )
    )


def compare_to_cloud(points: ArrayLike, truth: ArrayLike, *, threads: int = 0) -> CloudError:
    """Compare points with the true cloud; those that are not finite are left out.

    The distances grow with the spacing of the truth, even for points on the true surface: compare
    only clouds that were measured against the same truth.
    """
    to_truth, coverage, chamfer = _core.compare_to_cloud(
        vectors("points", points), vectors("truth", truth), threads
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
            surface.vertices,
            surface.triangles,
            whole("samples", samples),
            whole("seed", seed),
            threads,
        )
    )


def mean_spacing(surface: TriangleMesh, count: int) -> float:
    """Mean spacing of so many points on a surface: sqrt(area / count), 0 for none."""
    return _core.mean_spacing(surface.vertices, surface.triangles, whole("count", count))


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
            *_core.normal_error_to_surface(at, of, truth.vertices, truth.triangles, threads)
        )
    if truth.normals is None:
        raise ValueError("truth must have normals, got none")
    return NormalError(*_core.normal_error_to_cloud(at, of, truth.points, truth.normals, threads))


def find_sharp_features(surface: TriangleMesh) -> SharpFeatures:
    """Find the edges at which faces meet at more than 30 degrees, and the corners of these."""
    return SharpFeatures(*_core.find_sharp_features(surface.vertices, surface.triangles))


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
            surface.vertices,
            surface.triangles,
            np.ascontiguousarray(sharp.edges, dtype=np.float64),
            vectors("corners", sharp.corners),
            real("spacing", spacing),
            threads,
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
            threads,
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

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Neighbours and normals, stages of the published method, under their C++ names."""

from __future__ import annotations

from typing import Literal

from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, real, vectors, whole
from ._core import Neighborhoods
from .denoising import ProgressFunction


def find_neighbors(
    points: ArrayLike,
    *,
    max_count: int = 0,
    radius: float = 0.0,
    threads: int = 0,
    on_progress: ProgressFunction | None = None,
) -> Neighborhoods:
    """Find the neighbours of every point, exactly.

    Parameters
    ----------
    points : array (N, 3)
        All finite. Duplicates are neighbours at distance 0.
    max_count : int
        At most so many, the nearest; 0 for no limit. At least one of the limits must be given.
    radius : float
        No farther than this (inclusive), in the unit of the points; 0 for no limit.
    threads : int, 0 to 256
    on_progress : callable, optional
        As for denoise().

    Returns
    -------
    Neighborhoods
        Those of a point do not include the point itself and are sorted by (distance, index).

    Raises
    ------
    ValueError
        If neither limit is given, one is out of its range, or a point is not finite.
    DataError
        If the neighbourhoods would hold more than 2^32 indices.
    """
    return _core.find_neighbors(
        vectors("points", points),
        whole("max_count", max_count),
        real("radius", radius),
        whole("threads", threads),
        on_progress,
    )


def mean_neighbor_distance(
    points: ArrayLike, neighborhoods: Neighborhoods, *, threads: int = 0
) -> float:
    """Mean distance from a point to its neighbours, over all points and all their neighbours.

    The "dbar" of Yadav et al. 2018 when every point has its 12 nearest.

    Returns
    -------
    float
        In the unit of the points; 0 when no point has a neighbour.
    """
    return _core.mean_neighbor_distance(
        vectors("points", points), neighborhoods, whole("threads", threads)
    )


def estimate_normals(
    points: ArrayLike, neighborhoods: Neighborhoods, *, threads: int = 0
) -> Floats:
    """Normals by principal component analysis of the neighbours about their mean.

    Returns
    -------
    array (N, 3) float64
        Unit vectors of arbitrary sign (see orient_normals); zero for a point with fewer than 2
        neighbours, or whose neighbours all coincide.

    Raises
    ------
    ValueError
        If points and neighborhoods differ in size.

    References
    ----------
    Yadav et al. 2018, initial normals.
    """
    return _core.estimate_normals(
        vectors("points", points), neighborhoods, whole("threads", threads)
    )


def refit_normals(
    points: ArrayLike,
    normals: ArrayLike,
    neighborhoods: Neighborhoods,
    *,
    position_scale: float,
    normal_scale: float = 0.3,
    blend: float = 0.5,
    threads: int = 0,
) -> Floats:
    """Fit normals again around normals that are nearly right, so that the fit stops at edges.

    Parameters
    ----------
    points, normals : array (N, 3)
    neighborhoods : Neighborhoods
    position_scale : float
        Gaussian scale of the distance, in the unit of the points, > 0.
    normal_scale : float
        Gaussian scale of the difference of two normals, without unit, > 0.
    blend : float, 0 to 1
        Share of the new normal in the mix with the old one.

    Returns
    -------
    array (N, 3) float64
        A point without a normal, or with fewer than 3 points in the fit, keeps what it has.

    Raises
    ------
    ValueError
        If sizes differ or an option is out of its range.
    """
    return _core.refit_normals(
        vectors("points", points),
        vectors("normals", normals),
        neighborhoods,
        real("position_scale", position_scale),
        real("normal_scale", normal_scale),
        real("blend", blend),
        whole("threads", threads),
    )


def orient_normals(
    points: ArrayLike, normals: ArrayLike, neighborhoods: Neighborhoods, *, threads: int = 0
) -> Floats:
    """Give neighbouring normals the same side, along a minimum spanning tree.

    Returns
    -------
    array (N, 3) float64
        Each connected piece starts from its highest point, whose normal points up. Zero normals
        stay zero. The signs that come in have no influence.

    Raises
    ------
    ValueError
        If points, normals and neighborhoods differ in size.

    References
    ----------
    Yadav et al. 2018, initial normals; after Hoppe et al. 1992.
    """
    return _core.orient_normals(
        vectors("points", points),
        vectors("normals", normals),
        neighborhoods,
        whole("threads", threads),
    )


def filter_normals(
    normals: ArrayLike,
    neighborhoods: Neighborhoods,
    *,
    rho: float = 0.9,
    tau: float = 0.25,
    damping: float = 3.0,
    eigen_tolerance: float = 0.0,
    voteless: Literal["keep", "zero"] = "keep",
    threads: int = 0,
) -> Floats:
    """Filter normals by voting tensors with binary eigenvalues.

    Parameters
    ----------
    normals : array (N, 3)
        Zero normals neither vote nor change.
    neighborhoods : Neighborhoods
    rho : float in [0, 1)
        A neighbour votes when the cosine of the two normals is larger.
    tau : float in (0, 1)
        Eigenvalues below this share of their sum become 0, the others 1.
    damping : float in [0, 1e6]
        Share of the old normal against the filtered one.
    eigen_tolerance : float
        The eigen-decomposition stops when the off-diagonal entries sum to this; 0 for full
        precision.
    voteless : "keep" or "zero"
        What becomes of a point for which no neighbour votes.

    Returns
    -------
    array (N, 3) float64

    Raises
    ------
    ValueError
        If sizes differ or an option is out of its range.

    References
    ----------
    Yadav et al. 2018, vertex-based normal voting tensor and binary eigenvalue optimisation.
    """
    return _core.filter_normals(
        vectors("normals", normals),
        neighborhoods,
        real("rho", rho),
        real("tau", tau),
        real("damping", damping),
        real("eigen_tolerance", eigen_tolerance),
        voteless,
        whole("threads", threads),
    )

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Features and moves of points, stages of the published method, under their C++ names."""

from __future__ import annotations

from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Bytes, Floats, real, values, vectors, whole
from ._core import Neighborhoods


class FeatureField(NamedTuple):
    """The class of every point and the frame that its position update needs."""

    #: (N,) uint8, see Feature.
    label: Bytes
    #: (N, 3), unit vector along the edge at edge points, zero elsewhere.
    direction: Floats


def classify_features(
    points: ArrayLike,
    normals: ArrayLike,
    neighborhoods: Neighborhoods,
    *,
    rho: float = 0.9,
    tau: float = 0.25,
    eigen_tolerance: float = 0.0,
    threads: int = 0,
) -> FeatureField:
    """Sort points into surface, edge and corner by the spectrum of a covariance.

    Parameters
    ----------
    points, normals : array (N, 3)
    neighborhoods : Neighborhoods
    rho : float in [0, 1)
        A neighbour counts when the cosine of the two normals is larger.
    tau : float in (0, 1)
        Threshold on the eigenvalues divided by their Euclidean norm.
    eigen_tolerance : float
        Where the eigen-decomposition stops, in squared units of the points; 0 for full precision.

    Returns
    -------
    FeatureField
        A point without a neighbour of similar normal is isolated.

    Raises
    ------
    ValueError
        If sizes differ or an option is out of its range.

    References
    ----------
    Yadav et al. 2018, feature classification by weighted covariance.
    """
    return FeatureField(
        *_core.classify_features(
            vectors("points", points),
            vectors("normals", normals),
            neighborhoods,
            _classes(rho, tau, eigen_tolerance),
            threads,
        )
    )


def update_positions(
    original: ArrayLike,
    points: ArrayLike,
    normals: ArrayLike,
    features: FeatureField,
    neighborhoods: Neighborhoods,
    *,
    position_scale: float,
    normal_scale: float = 0.3,
    step: float = 0.5,
    feature_step: float = 0.5,
    max_move: float = 0.0,
    offset: Literal["projected", "symmetric"] = "symmetric",
    quadric: Literal["plain", "guarded"] = "guarded",
    bound: Literal["reject", "clamp"] = "clamp",
    threads: int = 0,
) -> Floats:
    """Move every point by a quadric error with the constraint of its class, all at once.

    Parameters
    ----------
    original : array (N, 3)
        Positions before the first round, which max_move is measured from.
    points, normals : array (N, 3)
    features : FeatureField
    neighborhoods : Neighborhoods
    position_scale : float
        Scale of the weights of distances, in the unit of the points, > 0.
    normal_scale : float
        Scale of the weights of differences of normals, > 0.
    step, feature_step : float in (0, 1]
        Share of its move that a surface point, and an edge or corner point, takes.
    max_move : float
        Largest distance from the original position, >= 0, in the unit of the points.
    offset : "projected" or "symmetric"
        Along which normal offsets are measured: that of the point (published) or the mean of two.
    quadric : "plain" or "guarded"
        Whether the quadric of edges and corners is kept from being singular.
    bound : "reject" or "clamp"
        Whether a point that would move too far stays or stops at the bound.

    Returns
    -------
    array (N, 3) float64
        Isolated points, and those that would not be finite, stay.

    Raises
    ------
    ValueError
        If sizes differ or an option is out of its range.

    References
    ----------
    Yadav et al. 2018, restricted quadratic error metrics; differs where options say so.
    """
    options = _update(
        (position_scale, normal_scale, step, feature_step, max_move), (offset, quadric, bound)
    )
    return _core.update_positions(
        vectors("original", original),
        vectors("points", points),
        vectors("normals", normals),
        values("features.label", features.label, np.uint8),
        vectors("features.direction", features.direction),
        neighborhoods,
        options,
        threads,
    )


def sweep_at_once(
    original: ArrayLike,
    points: ArrayLike,
    normals: ArrayLike,
    neighborhoods: Neighborhoods,
    *,
    rho: float = 0.9,
    tau: float = 0.25,
    eigen_tolerance: float = 0.0,
    position_scale: float,
    normal_scale: float = 0.3,
    step: float = 0.5,
    feature_step: float = 0.5,
    max_move: float = 0.0,
    offset: Literal["projected", "symmetric"] = "symmetric",
    quadric: Literal["plain", "guarded"] = "guarded",
    bound: Literal["reject", "clamp"] = "clamp",
    threads: int = 0,
) -> tuple[Floats, FeatureField]:
    """classify_features() and update_positions() in one pass, which is faster.

    Parameters
    ----------
    original, points, normals, neighborhoods
        As of update_positions().
    rho, tau, eigen_tolerance
        As of classify_features().
    position_scale, normal_scale, step, feature_step, max_move, offset, quadric, bound
        As of update_positions().

    Returns
    -------
    (points, features)
        The same bits as of the two functions.

    Raises
    ------
    ValueError
        If sizes differ or an option is out of its range.
    """
    return _sweep(
        (original, points, normals),
        neighborhoods,
        _classes(rho, tau, eigen_tolerance),
        _update(
            (position_scale, normal_scale, step, feature_step, max_move), (offset, quadric, bound)
        ),
        None,
        threads,
    )


def sweep_in_place(
    original: ArrayLike,
    points: ArrayLike,
    normals: ArrayLike,
    neighborhoods: Neighborhoods,
    *,
    order: ArrayLike = (),
    rho: float = 0.9,
    tau: float = 0.25,
    eigen_tolerance: float = 0.0,
    position_scale: float,
    normal_scale: float = 0.3,
    step: float = 0.5,
    feature_step: float = 0.5,
    max_move: float = 0.0,
    offset: Literal["projected", "symmetric"] = "symmetric",
    quadric: Literal["plain", "guarded"] = "guarded",
    bound: Literal["reject", "clamp"] = "clamp",
) -> tuple[Floats, FeatureField]:
    """The sweep of the authors' program: one point after the other, on one thread.

    A point sees the new positions of those before it. The arrays that are given stay as they are.

    Parameters
    ----------
    original, points, normals, neighborhoods
        As of update_positions().
    order : array (M,) of integers
        Points to move, in this order; empty for all, by index.
    rho, tau, eigen_tolerance
        As of classify_features().
    position_scale, normal_scale, step, feature_step, max_move, offset, quadric, bound
        As of update_positions().

    Returns
    -------
    (points, features)
        The class of every point is that at the moment when it was moved.

    Raises
    ------
    ValueError
        If sizes differ or an option is out of its range.
    """
    return _sweep(
        (original, points, normals),
        neighborhoods,
        _classes(rho, tau, eigen_tolerance),
        _update(
            (position_scale, normal_scale, step, feature_step, max_move), (offset, quadric, bound)
        ),
        values("order", np.asarray(order, dtype=None if np.size(order) else np.uint32), np.uint32),
        1,
    )


_CLASSES = ("rho", "tau", "eigen_tolerance")
_LENGTHS = ("position_scale", "normal_scale", "step", "feature_step", "max_move")
_Update = tuple[float, float, float, float, float, str, str, str]


def _classes(*options: float) -> tuple[float, float, float]:
    rho, tau, eigen_tolerance = map(real, _CLASSES, options)
    return rho, tau, eigen_tolerance


def _update(lengths: tuple[float, ...], words: tuple[str, str, str]) -> _Update:
    position_scale, normal_scale, step, feature_step, max_move = map(real, _LENGTHS, lengths)
    return (position_scale, normal_scale, step, feature_step, max_move, *words)


def _sweep(
    arrays: tuple[ArrayLike, ArrayLike, ArrayLike],
    neighborhoods: Neighborhoods,
    classes: tuple[float, float, float],
    update: _Update,
    order: NDArray[np.uint32] | None,
    threads: int,
) -> tuple[Floats, FeatureField]:
    original, points, normals = map(vectors, ("original", "points", "normals"), arrays)
    moved, field = _core.sweep(
        original, points, normals, neighborhoods, classes, update, order, whole("threads", threads)
    )
    return moved, FeatureField(*field)

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Classes and moves of points in one pass, as the published program has it."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Floats, values, vectors, whole
from ._core import Neighborhoods
from .features import FeatureField, class_options
from .positions import UpdateOptions, update_options


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
        class_options(rho, tau, eigen_tolerance),
        update_options(
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
        class_options(rho, tau, eigen_tolerance),
        update_options(
            (position_scale, normal_scale, step, feature_step, max_move), (offset, quadric, bound)
        ),
        values("order", np.asarray(order, dtype=None if np.size(order) else np.uint32), np.uint32),
        1,
    )


def _sweep(
    arrays: tuple[ArrayLike, ArrayLike, ArrayLike],
    neighborhoods: Neighborhoods,
    classes: tuple[float, float, float],
    update: UpdateOptions,
    order: NDArray[np.uint32] | None,
    threads: int,
) -> tuple[Floats, FeatureField]:
    original, points, normals = map(vectors, ("original", "points", "normals"), arrays)
    moved, field = _core.sweep(
        original, points, normals, neighborhoods, classes, update, order, whole("threads", threads)
    )
    return moved, FeatureField(*field)

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Moves of points, a stage of the published method, under its C++ name."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, real, values, vectors, whole
from ._core import Neighborhoods
from .features import FeatureField

_LENGTHS = ("position_scale", "normal_scale", "step", "feature_step", "max_move")
UpdateOptions = tuple[float, float, float, float, float, str, str, str]


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
    options = update_options(
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
        whole("threads", threads),
    )


def update_options(lengths: tuple[float, ...], words: tuple[str, str, str]) -> UpdateOptions:
    """Options of update_positions() as the C++ side takes them."""
    position_scale, normal_scale, step, feature_step, max_move = map(real, _LENGTHS, lengths)
    return (position_scale, normal_scale, step, feature_step, max_move, *words)

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Noise and outliers of a cloud."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, Mask, real, vectors, whole
from .denoising import ProgressFunction


class NoiseEstimate(NamedTuple):
    """The noise of a cloud, and lengths to compare it with; all in the unit of the points."""

    #: Standard deviation of the noise across the surface.
    sigma: float
    #: Square root of the area of the surface per point.
    spacing: float
    #: Radius about a point within which noise can be told from surface.
    reach: float
    #: Distance of two sheets that lie over each other in most of the cloud, so close that they
    #: look like one with more noise; 0 where there is no evidence of them.
    gap: float


class LocalNoise(NamedTuple):
    """The noise of a cloud from place to place, in the unit of the points."""

    overall: NoiseEstimate
    #: (N,), at each point; overall.sigma where nothing else is evident.
    sigma: Floats
    #: (N,), at each point.
    spacing: Floats


def measure_noise(points: ArrayLike, *, threads: int = 0) -> NoiseEstimate:
    """Estimate the noise from the points alone.

    Parameters
    ----------
    points : array (N, 3)
        Points that are not finite do not count, and of those at the same place one does.
    threads : int, 0 to 256

    Returns
    -------
    NoiseEstimate
        All 0 when fewer than 16 points are left. See docs/method/noise.md.
    """
    return NoiseEstimate(*_core.measure_noise(vectors("points", points), whole("threads", threads)))


def estimate_noise(points: ArrayLike, *, threads: int = 0) -> float:
    """The standard deviation of the noise: measure_noise(points).sigma."""
    return measure_noise(points, threads=threads).sigma


def estimate_local_noise(points: ArrayLike, *, threads: int = 0) -> LocalNoise:
    """Estimate noise and spacing at each point, where they differ from place to place.

    Parameters
    ----------
    points : array (N, 3)
    threads : int, 0 to 256

    Returns
    -------
    LocalNoise
        Differences of less than a fifth are not believed. A point that is not finite has the
        overall values, and so have all where overall.gap > 0.
    """
    overall, sigma, spacing = _core.estimate_local_noise(
        vectors("points", points), whole("threads", threads)
    )
    return LocalNoise(NoiseEstimate(*overall), sigma, spacing)


def find_outliers(
    points: ArrayLike,
    *,
    tolerance: float = 1.0,
    threads: int = 0,
    on_progress: ProgressFunction | None = None,
) -> Mask:
    """Find points that do not belong to the surface that the others sample.

    Single ones, scattered ones, and groups of at most 128 points, however dense. Noise and spacing
    are taken from the cloud, from place to place.

    Parameters
    ----------
    points : array (N, 3)
    tolerance : float, 0.1 to 10
        Multiplies every distance that a point may have from the surface: above 1 fewer points are
        flagged, below 1 more.
    threads : int, 0 to 256
    on_progress : callable, optional
        As for denoise().

    Returns
    -------
    array (N,) bool
        Points that are not finite are False; all are when fewer than 64 distinct finite points are
        there, too few to make out a surface.

    Raises
    ------
    ValueError
        For an option out of its range.
    """
    flags = _core.find_outliers(
        vectors("points", points),
        real("tolerance", tolerance),
        whole("threads", threads),
        on_progress,
    )
    return flags.view(np.bool_)

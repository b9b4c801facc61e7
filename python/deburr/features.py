# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Classes of points, a stage of the published method, under its C++ name."""

from __future__ import annotations

from typing import NamedTuple

from numpy.typing import ArrayLike

from . import _core
from ._arrays import Bytes, Floats, real, vectors, whole
from ._core import Neighborhoods

_OPTIONS = ("rho", "tau", "eigen_tolerance")


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
            class_options(rho, tau, eigen_tolerance),
            whole("threads", threads),
        )
    )


def class_options(*options: float) -> tuple[float, float, float]:
    """rho, tau and eigen_tolerance as the C++ side takes them."""
    rho, tau, eigen_tolerance = map(real, _OPTIONS, options)
    return rho, tau, eigen_tolerance

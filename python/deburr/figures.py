# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Figures that tell how far a cloud is from what is known to be true."""

from __future__ import annotations

from dataclasses import dataclass

from ._arrays import Floats


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

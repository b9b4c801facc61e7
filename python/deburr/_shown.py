# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What a page shows of the things that denoise() takes and gives."""

from __future__ import annotations

from typing import Any

from . import _bridge, metrics
from ._arrays import Floats, vectors
from ._clouds import cloud_of
from .cloud import PointCloud
from .layout import FileLayout
from .mesh import TriangleMesh
from .result import Result
from .synthetic import SyntheticScan

Truth = TriangleMesh | PointCloud | SyntheticScan | Any


def before_of(result: Result) -> PointCloud | None:
    """What denoise() was given, where that is still known."""
    given = result._given
    if given is None:
        return None
    if given.cloud is not None:
        return given.cloud
    return cloud_of(given.points if given.original is None else given.original)


def distances(cloud: PointCloud, truth: Truth, threads: int) -> Floats | None:
    """How far each point lies from the truth, None without one."""
    if truth is None:
        return None
    if isinstance(truth, SyntheticScan):
        truth = truth.truth
    if isinstance(truth, TriangleMesh):
        return metrics.distance_to_surface(cloud.points, truth, threads=threads)
    return metrics.distance_to_cloud(cloud.points, cloud_of(truth).points, threads=threads)


def to_core(name: str, cloud: PointCloud, distance: Floats | None) -> tuple[Any, ...]:
    """What the C++ side makes a page from: of the layout, only the comments are shown."""
    layout = FileLayout(comments=cloud.layout.comments, obj_info=cloud.layout.obj_info)
    parts = {
        "points": vectors("points", cloud.points),
        "normals": None if cloud.normals is None else vectors("normals", cloud.normals),
        "attributes": _bridge.fields_to_core(cloud.fields),
        "layout": _bridge.layout_to_core(layout),
    }
    return (name, parts, distance)

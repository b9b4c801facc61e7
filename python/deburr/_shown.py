# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What a page shows of the things that denoise() takes and gives."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _bridge, _foreign, metrics
from ._arrays import Floats, vectors
from .cloud import PointCloud
from .layout import FileLayout
from .mesh import TriangleMesh
from .result import Result
from .synthetic import SyntheticScan

_CHANNELS = ("red", "green", "blue")
#: Where PyVista clouds usually have their colours.
_COLOUR_ARRAYS = ("RGB", "RGBA", "rgb", "rgba", "colors", "Colors")

Truth = TriangleMesh | PointCloud | SyntheticScan | Any


def cloud_of(thing: Any) -> PointCloud:
    """The points with their fields; those of a Result with labels, outliers and displacement."""
    if isinstance(thing, Result):
        cloud = thing.to_cloud()
        given = thing._given
        return _coloured(cloud, given.original if given else None, thing.kept)
    if isinstance(thing, SyntheticScan):
        return thing.cloud
    given = _foreign.take_in(thing)
    if given.cloud is not None:
        return given.cloud
    normals = None if given.normals is None else vectors("normals", given.normals)
    return _coloured(PointCloud(vectors("points", given.points), normals), given.original, None)


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


def _coloured(cloud: PointCloud, original: Any, kept: NDArray[np.uint64] | None) -> PointCloud:
    """The cloud with the colours of an Open3D or PyVista object, unless it has some."""
    if original is None or any(name in cloud.fields for name in _CHANNELS):
        return cloud
    colours = _colours(original)
    if colours is None or colours.ndim != 2 or colours.shape[1] < 3:
        return cloud
    if kept is not None:
        colours = colours[kept.astype(np.intp)]
    if len(colours) != len(cloud) or colours.dtype.kind not in "uif":
        return cloud
    channels = {name: np.ascontiguousarray(colours[:, k]) for k, name in enumerate(_CHANNELS)}
    return dataclasses.replace(cloud, fields={**cloud.fields, **channels})


def _colours(original: Any) -> NDArray[Any] | None:
    if hasattr(original, "has_colors"):
        return np.asarray(original.colors) if original.has_colors() else None
    if hasattr(original, "point") and "colors" in original.point:
        array: NDArray[Any] = original.point["colors"].cpu().numpy()
        return array
    held = getattr(original, "point_data", None)
    if held is not None:
        for name in _COLOUR_ARRAYS:
            if name in held:
                return np.asarray(held[name])
    return None

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""A cloud of whatever holds points."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _foreign
from ._arrays import vectors
from .cloud import PointCloud
from .result import Result

_CHANNELS = ("red", "green", "blue")
#: Where PyVista clouds usually have their colours.
_COLOUR_ARRAYS = ("RGB", "RGBA", "rgb", "rgba", "colors", "Colors")


def cloud_of(thing: Any) -> PointCloud:
    """The points with their fields; those of a Result with labels, outliers and displacement."""
    if isinstance(thing, Result):
        cloud = thing.to_cloud()
        given = thing._given
        return _coloured(cloud, given.original if given else None, thing.kept)
    given = _foreign.take_in(thing)
    if given.cloud is not None:
        return given.cloud
    normals = None if given.normals is None else vectors("normals", given.normals)
    return _coloured(PointCloud(vectors("points", given.points), normals), given.original, None)


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

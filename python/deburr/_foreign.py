# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Clouds of other libraries, told by what they have, so that none of these has to be imported."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ._arrays import Points, any_vectors
from .cloud import PointCloud

if TYPE_CHECKING:
    from .result import Result


@dataclass(frozen=True)
class Given:
    """What denoise() was given."""

    points: Points
    normals: Points | None = None
    #: Where the input was a cloud with fields.
    cloud: PointCloud | None = None
    original: Any = None
    rebuild: Callable[[Any, Result], Any] | None = None

    def give_back(self, result: Result) -> Any:
        """The result as an object of the kind that came in."""
        if self.rebuild is not None and self.original is not None:
            return self.rebuild(self.original, result)
        return result.points if self.cloud is None else result.to_cloud()

    def without_original(self) -> Given | None:
        """What can be pickled: fields, but neither foreign objects nor what only they need."""
        if self.cloud is None:
            return None
        return replace(self, original=None, rebuild=None)


def take_in(given: Any) -> Given:
    """Finds out what was given."""
    if isinstance(given, PointCloud):
        return Given(given.points, given.normals, given)
    if _has(given, "cloud", "truth", "clean"):  # a SyntheticScan
        return take_in(given.cloud)
    if _has(given, "to_cloud", "report"):  # a Result
        return take_in(given.to_cloud())
    if _has(given, "point", "clone") and "positions" in given.point:
        return _open3d_tensor(given)
    if _has(given, "points", "has_normals", "has_colors"):
        normals = any_vectors("normals", given.normals) if given.has_normals() else None
        points = any_vectors("points", given.points)
        return Given(points, normals, None, given, _to_open3d)
    if _has(given, "points", "point_data", "copy"):
        return _pyvista(given)
    if _has(given, "point_format", "header", "vlrs"):
        from . import _laz

        cloud = _laz.from_laspy(given)
        return Given(
            cloud.points, cloud.normals, cloud, given, lambda _, result: _laz.of_result(result)
        )
    if isinstance(given, np.ndarray) and given.dtype.names is not None:
        cloud = PointCloud.from_structured(given)
        return Given(cloud.points, cloud.normals, cloud, given, _to_structured)
    if _has(given, "columns", "to_numpy", "iloc"):
        cloud = PointCloud.from_dataframe(given)
        return Given(cloud.points, cloud.normals, cloud, given, _to_dataframe)
    return Given(any_vectors("points", given))


def _has(thing: Any, *names: str) -> bool:
    return all(hasattr(thing, name) for name in names)


def _added(result: Result) -> dict[str, NDArray[Any]]:
    return {
        "deburr_label": result.labels,
        "deburr_displacement": result.displacement.astype(np.float32),
        "deburr_outlier": result.outliers.astype(np.uint8),
    }


def _indices(result: Result) -> NDArray[np.intp] | None:
    return None if result.kept is None else result.kept.astype(np.intp)


def _to_open3d(original: Any, result: Result) -> Any:
    """A legacy cloud; its class is also that of its vectors, so nothing has to be imported."""
    indices = _indices(result)
    clean = type(original)(original)
    if indices is not None:
        clean = clean.select_by_index(indices.tolist())
    vector = type(original.points)
    clean.points = vector(result.points.astype(np.float64))
    clean.normals = vector(result.normals)
    return clean


def _open3d_tensor(given: Any) -> Given:
    def array(name: str) -> Points:
        return any_vectors(name, given.point[name].cpu().numpy())

    normals = array("normals") if "normals" in given.point else None
    return Given(array("positions"), normals, None, given, _to_open3d_tensor)


def _to_open3d_tensor(original: Any, result: Result) -> Any:
    indices = _indices(result)
    clean = original.clone()
    positions = original.point["positions"]
    tensor, device = type(positions), positions.device
    moved = {"positions": result.points, "normals": result.normals.astype(result.points.dtype)}
    moved.update({name: value[:, np.newaxis] for name, value in _added(result).items()})
    for name in clean.point:
        if name not in moved and indices is not None:
            moved[name] = original.point[name].cpu().numpy()[indices]
    # A cloud refuses attributes of two lengths only when it is used.
    for name, value in moved.items():
        clean.point[name] = tensor.from_numpy(np.ascontiguousarray(value)).to(device)
    return clean


def _pyvista(given: Any) -> Given:
    normals = given.point_data["Normals"] if "Normals" in given.point_data else None  # noqa: SIM401
    return Given(
        any_vectors("points", np.asarray(given.points)),
        None if normals is None else any_vectors("normals", np.asarray(normals)),
        None,
        given,
        _to_pyvista,
    )


def _to_pyvista(original: Any, result: Result) -> Any:
    """A mesh with its faces; without them where points were removed."""
    indices = _indices(result)
    if indices is None:
        clean = original.copy()
        clean.points = result.points
    else:
        clean = type(original)(result.points)
        for name in original.point_data:
            clean.point_data[name] = np.asarray(original.point_data[name])[indices]
    clean.point_data["Normals"] = result.normals.astype(result.points.dtype)
    for name, value in _added(result).items():
        clean.point_data[name] = value
    return clean


def _to_structured(original: Any, result: Result) -> NDArray[np.void]:
    table = result.to_cloud().to_structured()
    return table[_with_new_ones_last(original.dtype.names, table.dtype.names or ())]


def _with_new_ones_last(before: Iterable[str], after: Iterable[str]) -> list[str]:
    return [*dict.fromkeys([*map(str, before), *after])]


def _to_dataframe(original: Any, result: Result) -> Any:
    frame = result.to_cloud().to_dataframe()
    frame = frame[_with_new_ones_last(original.columns, frame.columns)]
    indices = _indices(result)
    frame.index = original.index if indices is None else original.index[indices]
    return frame

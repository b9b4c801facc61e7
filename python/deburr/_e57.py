# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""E57: pye57 has the container, this has what a cloud needs of it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _e57_tree as tree
from ._e57_pose import Pose
from ._errors import DeburrIOError
from .cloud import PointCloud
from .layout import FieldValues, HeaderBlock, Lists

_MAGIC = b"ASTM-E57"
FILE_BLOCK = "E57 file"
SCAN_BLOCK = "E57 scan {}"
SCAN_FIELD = "scan"
XYZ = ("cartesianX", "cartesianY", "cartesianZ")
SPHERICAL = ("sphericalRange", "sphericalAzimuth", "sphericalElevation")
NORMALS = ("nor:normalX", "nor:normalY", "nor:normalZ")
INVALID = "cartesianInvalidState"
SPHERICAL_INVALID = "sphericalInvalidState"
#: Names that other formats share.
COMMON = {"colorRed": "red", "colorGreen": "green", "colorBlue": "blue"}
#: Fields that the format has no name for are of this extension.
PREFIX = "deburr:"


def is_e57(path: Path) -> bool:
    """Whether a file is E57 by its content."""
    try:
        with path.open("rb") as file:
            return file.read(len(_MAGIC)) == _MAGIC
    except OSError:
        return False  # the C++ side says what is wrong


def import_pye57(path: Path) -> Any:
    """The library, or how to get it."""
    try:
        import pye57
    except ImportError as error:
        raise ImportError(f"{path}: E57 needs pye57: pip install 'deburr[e57]'") from error
    return pye57


def read(path: Path) -> PointCloud:
    """Read all scans of an E57 file as one cloud."""
    libe57 = import_pye57(path).libe57
    try:
        image_file = libe57.ImageFile(str(path), "r")
        try:
            return _read_scans(libe57, image_file)
        finally:
            image_file.close()
    except libe57.E57Exception as error:
        raise DeburrIOError(f"{path}: {error}") from error


def write(path: Path, cloud: PointCloud) -> list[str]:
    """Write a cloud with the scans and headers that it was read with; returns what was lost."""
    from ._e57_write import write_e57

    return write_e57(path, cloud)


def _read_scans(libe57: Any, image_file: Any) -> PointCloud:
    root = image_file.root()
    extensions = [
        [image_file.extensionsPrefix(i), image_file.extensionsUri(i)]
        for i in range(image_file.extensionsCount())
    ]
    head = {"extensions": extensions, "root": tree.children(root, without=("data3D",))}
    blocks = [HeaderBlock(FILE_BLOCK, json.dumps(head).encode())]
    clouds = []
    scans = libe57.VectorNode(root.get("data3D"))
    for i in range(scans.childCount()):
        node = libe57.StructureNode(scans.get(i))
        vector = libe57.CompressedVectorNode(node.get("points"))
        prototype = tree.children(libe57.StructureNode(vector.prototype()))
        header = tree.children(node, without=("points",))
        kept = {"header": header, "prototype": prototype}
        blocks.append(HeaderBlock(SCAN_BLOCK.format(i), json.dumps(kept).encode()))
        columns = _read_columns(libe57, image_file, vector, prototype)
        clouds.append(_to_cloud(columns, Pose.of_header(header)))
    cloud = _join(clouds)
    cloud.layout.blocks = blocks
    return cloud


def _read_columns(
    libe57: Any, image_file: Any, vector: Any, prototype: dict[str, tree.Plain]
) -> dict[str, NDArray[Any]]:
    count = vector.childCount()
    # Strings cannot be read into arrays.
    types = {name: _dtype(name, plain) for name, plain in prototype.items() if plain[0] != "string"}
    columns = {name: np.empty(count, buffer_type(dtype)) for name, dtype in types.items()}
    buffers = libe57.VectorSourceDestBuffer()
    for name, array in columns.items():
        buffers.append(libe57.SourceDestBuffer(image_file, name, array, count, True, True))
    if count and columns:
        reader = vector.reader(buffers)
        reader.read()
        reader.close()
    return {name: array.astype(types[name], copy=False) for name, array in columns.items()}


def buffer_type(dtype: Any) -> np.dtype[Any]:
    """The type of an array that pye57 reads and writes right: 32 bits it knows by no name."""
    given = np.dtype(dtype)
    return np.dtype("q") if given.kind in "iu" and given.itemsize > 2 else given


def _dtype(name: str, plain: tree.Plain) -> Any:
    """The smallest type that holds a field."""
    kind, *values = plain
    if name in XYZ or name in SPHERICAL or kind == "scaled":
        return np.float64
    if kind == "float":
        return np.float32 if values[1] else np.float64
    least, most = values[1:]
    for dtype in (np.uint8, np.int8, np.uint16, np.int16, np.uint32, np.int32):
        limits = np.iinfo(dtype)
        if limits.min <= least and most <= limits.max:
            return dtype
    return np.int64


def _to_cloud(columns: dict[str, NDArray[Any]], pose: Pose) -> PointCloud:
    if all(name in columns for name in XYZ):
        local = np.stack([columns.pop(name) for name in XYZ], axis=1)
        for name in (*SPHERICAL, SPHERICAL_INVALID):
            columns.pop(name, None)  # says the same again, and would be wrong once points move
    elif all(name in columns for name in SPHERICAL):
        distance, azimuth, elevation = (columns.pop(name) for name in SPHERICAL)
        flat = distance * np.cos(elevation)
        local = np.stack(
            [flat * np.cos(azimuth), flat * np.sin(azimuth), distance * np.sin(elevation)], axis=1
        )
        if SPHERICAL_INVALID in columns:
            columns[INVALID] = columns.pop(SPHERICAL_INVALID)
    else:
        raise DeburrIOError("an E57 scan without coordinates")
    if INVALID in columns:
        # 2: no coordinates, 1: only their direction means something.
        local[columns[INVALID] != 0] = np.nan
    normals = None
    if all(name in columns for name in NORMALS):
        normals = pose.turn(np.stack([columns.pop(name) for name in NORMALS], axis=1))
    fields: dict[str, FieldValues] = {_field_name(name): a for name, a in columns.items()}
    return PointCloud(pose.to_file(local), normals, fields)


def _field_name(name: str) -> str:
    return COMMON.get(name, name.removeprefix(PREFIX))


def _join(clouds: list[PointCloud]) -> PointCloud:
    """All scans, one after the other; what a scan does not have is 0."""
    if len(clouds) == 1:
        return clouds[0]
    sizes = [len(cloud) for cloud in clouds]
    joined = PointCloud(np.concatenate([np.empty((0, 3)), *(c.points for c in clouds)]))
    if any(cloud.normals is not None for cloud in clouds):
        joined.normals = np.concatenate(
            [np.zeros_like(c.points) if c.normals is None else c.normals for c in clouds]
        )
    for name in dict.fromkeys(name for cloud in clouds for name in cloud.fields):
        parts = [cloud.fields.get(name) for cloud in clouds]
        dtype = np.result_type(*(p for p in parts if isinstance(p, np.ndarray)))
        joined.fields[name] = np.concatenate(
            [
                np.zeros(size, dtype) if part is None or isinstance(part, Lists) else part
                for part, size in zip(parts, sizes, strict=True)
            ]
        ).astype(dtype)
    joined.fields[SCAN_FIELD] = np.repeat(np.arange(len(clouds), dtype=np.int32), sizes)
    return joined

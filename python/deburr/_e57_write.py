# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Writing E57: the scans and headers that a cloud was read with, or one new scan."""

from __future__ import annotations

import json
import re
import uuid
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _e57
from . import _e57_tree as tree
from ._atomic import whole_file
from ._e57_pose import Pose
from ._errors import DataError, DeburrIOError
from .cloud import PointCloud
from .layout import Lists

_NORMALS_URI = "http://www.libe57.org/E57_NOR_surface_normals.txt"
_FIELDS_URI = "urn:deburr:fields"
#: Fields of points that the standard names; others have to be of an extension.
_STANDARD = {
    "intensity", "colorRed", "colorGreen", "colorBlue", "rowIndex", "columnIndex", "returnIndex",
    "returnCount", "timeStamp", "isIntensityInvalid", "isColorInvalid", "isTimeStampInvalid",
    "cartesianInvalidState",
}  # fmt: skip
_LIBRARY = {"e57LibraryVersion", "formatName", "versionMajor", "versionMinor"}
#: Kept as long as the points are; a removed point makes them wrong.
_OF_ORDER = ("pointGroupingSchemes", "sphericalBounds")


def write_e57(path: Path, cloud: PointCloud) -> list[str]:
    """Write a cloud, whole or not at all; returns what E57 could not hold."""
    if not np.isfinite(cloud.points).any():
        raise DataError("E57 needs a point that is finite")
    libe57 = _e57.import_pye57(path).libe57
    file = _File(libe57, cloud)
    try:
        with whole_file(path) as part:
            image_file = libe57.ImageFile(str(part), "w")
            try:
                file.write(image_file)
            finally:
                image_file.close()
    except libe57.E57Exception as error:
        raise DeburrIOError(f"{path}: {error}") from error
    return file.losses


class _File:
    def __init__(self, libe57: Any, cloud: PointCloud) -> None:
        self.libe57 = libe57
        self.cloud = cloud
        self.losses: list[str] = []
        blocks = {block.name: block.data for block in cloud.layout.blocks}
        self.head = json.loads(blocks.get(_e57.FILE_BLOCK, b'{"extensions": [], "root": {}}'))
        self.scans: list[dict[str, Any]] = []
        while (name := _e57.SCAN_BLOCK.format(len(self.scans))) in blocks:
            self.scans.append(json.loads(blocks[name]))
        foreign = [name for name in blocks if not name.startswith("E57 ")]
        if foreign:
            self.losses.append(f"E57 cannot hold: {', '.join(foreign)}; left out")
        if cloud.layout.comments or cloud.layout.obj_info:
            count = len(cloud.layout.comments) + len(cloud.layout.obj_info)
            self.losses.append(f"E57 cannot hold comments, {count} left out")
        for element in cloud.layout.elements:
            self.losses.append(
                f"E57 cannot hold the element '{element.name}' ({element.size} items), which was "
                "left out"
            )
        if not self.scans:
            self.scans = [{"header": {}, "prototype": {}}]
        self.columns = self._columns()

    def _columns(self) -> dict[str, NDArray[Any]]:
        """Numbers of the fields under their names in E57."""
        back = {common: name for name, common in _e57.COMMON.items()}
        declared = {name for scan in self.scans for name in scan["prototype"]}
        columns = {}
        for name, value in self.cloud.fields.items():
            if name == _e57.SCAN_FIELD and len(self.scans) > 1:
                continue
            if isinstance(value, Lists) or value.dtype.kind not in "iuf":
                kind = "lists" if isinstance(value, Lists) else "text"
                self.losses.append(f"E57 cannot hold the {kind} '{name}', which were left out")
                continue
            if value.dtype == np.uint64:
                self.losses.append(f"E57 cannot hold the 64-bit '{name}', which were left out")
                continue
            own = back.get(name, name)
            if own not in _STANDARD and own not in declared:
                own = _e57.PREFIX + re.sub(r"\W", "_", own, flags=re.ASCII)
            columns[own] = value
        return columns

    def _rows(self, number: int) -> NDArray[np.bool_]:
        which = self.cloud.fields.get(_e57.SCAN_FIELD)
        if len(self.scans) == 1 or not isinstance(which, np.ndarray):
            return np.full(len(self.cloud), number == 0)
        mask: NDArray[np.bool_] = np.equal(which, number)
        return mask

    def write(self, image_file: Any) -> None:
        libe57 = self.libe57
        known: dict[str, str] = dict(self.head["extensions"])
        known.setdefault("", libe57.E57_V1_0_URI)
        if self.cloud.normals is not None:
            known.setdefault("nor", _NORMALS_URI)
        if any(name.startswith(_e57.PREFIX) for name in self.columns):
            known.setdefault(_e57.PREFIX[:-1], _FIELDS_URI)
        for prefix, uri in known.items():
            image_file.extensionsAdd(prefix, uri)
        root = image_file.root()
        root.set("formatName", libe57.StringNode(image_file, "ASTM E57 3D Imaging Data File"))
        root.set("versionMajor", libe57.IntegerNode(image_file, libe57.E57_FORMAT_MAJOR))
        root.set("versionMinor", libe57.IntegerNode(image_file, libe57.E57_FORMAT_MINOR))
        root.set("e57LibraryVersion", libe57.StringNode(image_file, libe57.E57_LIBRARY_ID))
        head = {"guid": tree.text(f"{{{uuid.uuid4()}}}"), **self.head["root"]}
        for name, plain in head.items():
            if name not in _LIBRARY:
                tree.add(root, name, plain, image_file)
        data3d = libe57.VectorNode(image_file, True)
        root.set("data3D", data3d)
        for number, scan in enumerate(self.scans):
            self._write_scan(image_file, data3d, number, scan)

    def _write_scan(self, image_file: Any, data3d: Any, number: int, scan: dict[str, Any]) -> None:
        rows = self._rows(number)
        header = {
            "guid": tree.text(f"{{{uuid.uuid4()}}}"),
            "name": tree.text(f"scan {number}"),
            **scan["header"],
        }
        for name in _OF_ORDER:
            if header.pop(name, None) is not None and name == _OF_ORDER[0]:
                self.losses.append(f"the {name} of scan {number} were left out")
        columns = self._scan_columns(rows, Pose.of_header(header), scan["prototype"])
        local = [columns[name] for name in _e57.XYZ]
        valid: Any = columns.get(_e57.INVALID, np.zeros(len(local[0]), np.int8)) == 0
        if valid.any():
            bounds = {}
            for axis, values in zip("xyz", local, strict=True):
                bounds[f"{axis}Minimum"] = tree.real(values[valid].min())
                bounds[f"{axis}Maximum"] = tree.real(values[valid].max())
            header["cartesianBounds"] = ["structure", bounds]
        node = self.libe57.StructureNode(image_file)
        # Hung up first, since blobs are written where they hang.
        data3d.append(node)
        for name, plain in header.items():
            tree.add(node, name, plain, image_file)
        self._write_points(image_file, node, columns, scan["prototype"])

    def _scan_columns(
        self, rows: NDArray[np.bool_], pose: Pose, prototype: dict[str, tree.Plain]
    ) -> dict[str, NDArray[Any]]:
        local = pose.to_scan(self.cloud.points[rows])
        lost: Any = ~np.isfinite(local).all(axis=1)
        columns: dict[str, NDArray[Any]] = dict(
            zip(_e57.XYZ, np.where(lost[:, np.newaxis], 0.0, local).T, strict=True)
        )
        everywhere = {name for scan in self.scans for name in scan["prototype"]}
        for name, value in self.columns.items():
            # A scan has its own fields, and those that no scan had before.
            if name in prototype or name not in everywhere or len(self.scans) == 1:
                columns[name] = value[rows]
        if lost.any():
            before = columns.get(_e57.INVALID, np.zeros(len(local), np.int8))
            columns[_e57.INVALID] = np.where(lost & (before == 0), 2, before).astype(np.int8)
        if self.cloud.normals is not None:
            normals = pose.turn_back(self.cloud.normals[rows])
            columns.update(zip(_e57.NORMALS, normals.T, strict=True))
        return columns

    def _write_points(
        self,
        image_file: Any,
        node: Any,
        columns: dict[str, NDArray[Any]],
        prototype: dict[str, tree.Plain],
    ) -> None:
        libe57 = self.libe57
        shape = libe57.StructureNode(image_file)
        buffers = libe57.VectorSourceDestBuffer()
        held = []  # for as long as the buffers point into them
        for name, values in columns.items():
            tree.add(shape, name, _node_for(name, values, prototype.get(name)), image_file)
            array = np.ascontiguousarray(values, dtype=_e57.buffer_type(values.dtype))
            held.append(array)
            buffers.append(
                libe57.SourceDestBuffer(image_file, name, array, max(len(array), 1), True, True)
            )
        codecs = libe57.VectorNode(image_file, True)
        points = libe57.CompressedVectorNode(image_file, shape, codecs)
        node.set("points", points)
        writer = points.writer(buffers)
        if held and len(held[0]):
            writer.write(len(held[0]))
        writer.close()


def _node_for(name: str, values: NDArray[Any], before: tree.Plain | None) -> tree.Plain:
    """The type of a field: that of the file where it still fits."""
    if name in _e57.XYZ:
        return tree.real(0)
    if values.dtype.kind == "f":
        if before is not None and before[0] == "scaled":
            return before
        single = values.dtype.itemsize == 4
        most = float(np.finfo(values.dtype).max)
        if before is not None and before[0] == "float" and len(values):
            least, largest = before[3:]
            if least <= np.nanmin(values) and np.nanmax(values) <= largest:
                return ["float", before[1], single, least, largest]
        return ["float", 0.0, single, -most, most]
    least, most = (int(values.min()), int(values.max())) if len(values) else (0, 0)
    if before is not None and before[0] == "integer":
        least, most = min(least, before[2]), max(most, before[3])
    return ["integer", least, least, most]

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Writing COPC: LAZ whose chunks are the nodes of an octree that the file tells of.

Source: Hobu, Cloud Optimized Point Cloud Specification 1.0; ASPRS, LAS Specification 1.4 R15.
"""

from __future__ import annotations

import itertools
import shutil
import struct
from collections.abc import Iterator
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from . import _octree
from ._laz_codec import Head, format_size
from ._octree import Cube, Node

_USER = b"copc"
_INFO, _HIERARCHY = 1, 1000
_RECORD = struct.Struct("<H16sHH32s")
_EXTENDED = struct.Struct("<H16sHQ32s")
#: Centre and half edge of the cube, spacing, place and size of the hierarchy, range of GPS times.
_INFO_DATA = struct.Struct("<5d2Q2d88x")
#: Level, x, y, z; place, bytes and points of the chunk.
_ENTRY = struct.Struct("<4iQ2i")
_CHUNK_TABLE_PLACE = 8
_GPS_TIME_AT = 22
#: Where a header tells of its extended records.
_TAIL_AT = 235
#: Nodes that are packed at once, on all cores.
_BATCH = 64


def is_of_copc(record: bytes) -> bool:
    """Whether a record is about an octree, which holds for one file only."""
    user: bytes = _RECORD.unpack_from(record)[1]
    return user.rstrip(b"\0") == _USER


def pack(plain: BinaryIO, packed: BinaryIO) -> None:
    """LAS 1.4 of point format 6, 7 or 8 to COPC; other records stay."""
    import lazrs

    head = Head.read(plain)
    count, size = head.point_count, head.point_size
    points = np.frombuffer(plain.read(count * size), np.uint8).reshape(count, size)
    places, smallest = _coordinates(head, points)
    cube = _octree.cube_around(places, smallest)
    nodes = _octree.nodes_of(places, cube, _octree.LEAF)
    del places

    tail_at = head.tail_at
    head.records = [record for record in head.records if not is_of_copc(record)]
    head.records.insert(0, bytes(_RECORD.size + _INFO_DATA.size))
    extra = size - format_size(head.point_format)
    scheme = lazrs.LazVlr.new_for_compression(
        head.point_format, extra, use_variable_size_chunks=True
    )
    head.add_laszip(scheme.record_data())
    head.set_packed(True)
    points_at = packed.write(head.to_bytes())
    encoder: Any = lazrs.ParLasZipCompressor(packed, scheme)
    for some in _batches(nodes):
        encoder.compress_chunks([points[node.indices].tobytes() for node in some])
    encoder.done()
    packed.seek(points_at)
    chunks = lazrs.read_chunk_table(packed, scheme) if nodes else []

    hierarchy_at = packed.seek(0, 2)
    entries = _entries(nodes, chunks, points_at + _CHUNK_TABLE_PLACE)
    packed.write(_EXTENDED.pack(0, _USER, _HIERARCHY, len(entries), b"EPT hierarchy") + entries)
    others = 0 if tail_at is None else struct.unpack_from("<I", head.header, _TAIL_AT + 8)[0]
    if tail_at is not None:
        plain.seek(tail_at)
        shutil.copyfileobj(plain, packed)
    struct.pack_into("<QI", head.header, _TAIL_AT, hierarchy_at, others + 1)
    first_page = (hierarchy_at + _EXTENDED.size, len(entries))
    head.records[0] = _info(cube, first_page, _gps_times(points))
    packed.seek(0)
    packed.write(head.to_bytes())


def _coordinates(head: Head, points: NDArray[np.uint8]) -> tuple[NDArray[np.float64], float]:
    """Coordinates in the unit of the file, and the length of one step of its grid."""
    grid = np.array(struct.unpack_from("<6d", head.header, 131))
    steps = np.ascontiguousarray(points[:, :12]).view("<i4").astype(np.float64)
    return steps * grid[:3] + grid[3:], float(np.abs(grid[:3]).max())


def _gps_times(points: NDArray[np.uint8]) -> tuple[float, float]:
    times = np.ascontiguousarray(points[:, _GPS_TIME_AT : _GPS_TIME_AT + 8]).view("<f8")
    finite = times[np.isfinite(times)]
    return (float(finite.min()), float(finite.max())) if len(finite) else (0.0, 0.0)


def _batches(nodes: list[Node]) -> Iterator[tuple[Node, ...]]:
    rest = iter(nodes)
    while some := tuple(itertools.islice(rest, _BATCH)):
        yield some


def _info(cube: Cube, first_page: tuple[int, int], times: tuple[float, float]) -> bytes:
    data = _INFO_DATA.pack(*cube.center, cube.half, cube.spacing, *first_page, *times)
    return _RECORD.pack(0, _USER, _INFO, len(data), b"COPC info VLR") + data


def _entries(nodes: list[Node], chunks: list[tuple[int, int]], at: int) -> bytes:
    """One page of the hierarchy, with the chunks as they lie one behind the other."""
    if not nodes:
        return _ENTRY.pack(0, 0, 0, 0, 0, 0, 0)
    entries = bytearray()
    for node, (count, size) in zip(nodes, chunks, strict=True):
        entries += _ENTRY.pack(node.level, node.x, node.y, node.z, at, size, count)
        at += size
    return bytes(entries)

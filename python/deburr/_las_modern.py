# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Clouds as LAS 1.4 of point format 6, 7 or 8, the only ones that COPC has.

Source: ASPRS, LAS Specification 1.4 R15.
"""

from __future__ import annotations

import dataclasses
import struct
from typing import Any

import numpy as np

from . import _las_crs
from ._laz_codec import Head, format_size
from .cloud import PointCloud
from .layout import HeaderBlock

_HEADER_SIZE = 375
#: Kept of the global encoding: the kind of GPS time, and synthetic returns. Waveforms are not.
_KEPT_BITS = 0b01001
#: Has to be set in the newer formats: no coordinate system is in GeoTIFF keys.
_WKT_BIT = 0b10000
#: Where a header tells of its waveforms.
_WAVES_AT = 227
#: One step of the newer field in degrees.
_ANGLE_STEP = 0.006
_WITH_COLOURS = (2, 3, 5, 7)
_WITH_INFRARED = (8, 10)
_WITH_WAVES = (4, 5, 9, 10)


def is_modern(head: Head) -> bool:
    """Whether a file can become COPC as it is."""
    return (
        head.point_format in (6, 7, 8)
        and len(head.header) == _HEADER_SIZE
        and bool(head.header[6] & _WKT_BIT)
        and not any(head.header[_WAVES_AT : _WAVES_AT + 8])
    )


def modernise(cloud: PointCloud, head: Head) -> tuple[PointCloud, list[str]]:
    """A cloud that will be written as such a file, and what it could not keep.

    Parameters
    ----------
    cloud : PointCloud
    head : Head
        Of the older file that the cloud was written as, whose grid and records stay.
    """
    losses = []
    old = head.point_format
    new = 8 if old in _WITH_INFRARED else 7 if old in _WITH_COLOURS else 6
    header = bytearray(_HEADER_SIZE)
    kept = min(len(head.header), _HEADER_SIZE if head.header[25] >= 4 else _WAVES_AT)
    header[:kept] = head.header[:kept]
    header[25] = 4
    header[104] = new
    extra = head.point_size - format_size(old)
    struct.pack_into("<H", header, 105, format_size(new) + extra)
    struct.pack_into("<H", header, 94, _HEADER_SIZE)
    header[_WAVES_AT : _WAVES_AT + 8] = bytes(8)
    (bits,) = struct.unpack_from("<H", header, 6)
    struct.pack_into("<H", header, 6, (bits & _KEPT_BITS) | _WKT_BIT)
    records = [*head.records]
    if _las_crs.has_keys(records) and not _las_crs.has_wkt(records):
        translated = _las_crs.wkt_record(records)
        if translated is not None:
            records.append(translated)
        else:
            losses.append(
                "COPC has coordinate systems as WKT; that of this cloud, in GeoTIFF keys, was kept "
                "as it is, and not every program will find it (with pyproj, systems that have an "
                "EPSG number are translated)"
            )
    if len(head.header) > _HEADER_SIZE:
        losses.append("COPC has no bytes behind its header, those of this cloud were left out")
    if old in _WITH_WAVES:
        losses.append("COPC has no waveforms, their fields became extra bytes")
    blocks = [HeaderBlock("LAS header", bytes(header))]
    blocks += [HeaderBlock("LAS record", record) for record in records]
    blocks += [b for b in cloud.layout.blocks if b.name.startswith("LAS extended record")]
    layout = dataclasses.replace(
        cloud.layout, encoding="las", blocks=blocks, comments=[], obj_info=[], resolution=0.0
    )
    had_header = any(block.name == "LAS header" for block in cloud.layout.blocks)
    fields = _fields(cloud, not (had_header and cloud.layout.encoding == "las"))
    return dataclasses.replace(cloud, fields=fields, layout=layout), losses


def _fields(cloud: PointCloud, is_new: bool) -> dict[str, Any]:
    """The fields under the names of the newer formats."""
    fields: dict[str, Any] = {}
    for name, value in cloud.fields.items():
        is_rank = name == "scan_angle_rank" and "scan_angle" not in cloud.fields
        if is_rank and isinstance(value, np.ndarray) and value.dtype == np.int8:
            steps = np.rint(value.astype(np.float64) / _ANGLE_STEP)
            fields["scan_angle"] = steps.astype(np.int16)
        else:
            fields[name] = value
    if is_new:  # a point without any return would be none
        for name in ("return_number", "number_of_returns"):
            fields.setdefault(name, np.ones(len(cloud), np.uint8))
    return fields

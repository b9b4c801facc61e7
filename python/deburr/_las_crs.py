# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Coordinate systems of LAS: GeoTIFF keys, and WKT, which the newer point formats have instead.

Source: ASPRS, LAS Specification 1.4 R15; OGC, GeoTIFF 1.1.
"""

from __future__ import annotations

import struct

_PROJECTION = b"LASF_Projection"
_WKT, _GEO_KEYS = 2112, 34735
_PROJECTED, _GEOGRAPHIC, _VERTICAL = 3072, 2048, 4096
#: Numbers above are not of EPSG.
_LAST_OF_EPSG = 32766
_RECORD = struct.Struct("<H16sHH32s")


def has_wkt(records: list[bytes]) -> bool:
    """Whether there is a coordinate system as WKT."""
    return _data(records, _WKT) is not None


def has_keys(records: list[bytes]) -> bool:
    """Whether there is one in GeoTIFF keys."""
    return _data(records, _GEO_KEYS) is not None


def wkt_record(records: list[bytes]) -> bytes | None:
    """The keys as WKT; None where they name no EPSG system, or pyproj is not installed."""
    keys = _keys(_data(records, _GEO_KEYS) or b"")
    code = keys.get(_PROJECTED) or keys.get(_GEOGRAPHIC)
    if code is None:
        return None
    try:
        from pyproj import CRS
        from pyproj.crs import CompoundCRS
        from pyproj.exceptions import CRSError
    except ImportError:
        return None
    try:
        system = CRS.from_epsg(code)
        if _VERTICAL in keys:
            height = CRS.from_epsg(keys[_VERTICAL])
            system = CompoundCRS(f"{system.name} + {height.name}", [system, height])
        text: bytes = system.to_wkt("WKT1_GDAL").encode() + b"\0"
    except CRSError:
        return None
    return _RECORD.pack(0, _PROJECTION, _WKT, len(text), b"of the GeoTIFF keys") + text


def _data(records: list[bytes], number: int) -> bytes | None:
    for record in records:
        user, found = record[2:18].rstrip(b"\0"), int.from_bytes(record[18:20], "little")
        if (user, found) == (_PROJECTION, number):
            return record[_RECORD.size :]
    return None


def _keys(directory: bytes) -> dict[int, int]:
    """Numbers of EPSG by their keys."""
    words = struct.unpack(f"<{len(directory) // 2}H", directory[: len(directory) // 2 * 2])
    keys = {}
    for at in range(4, len(words) - 3, 4):
        key, place, _, value = words[at : at + 4]
        if place == 0 and key in (_PROJECTED, _GEOGRAPHIC, _VERTICAL) and value <= _LAST_OF_EPSG:
            keys[key] = value
    return {key: value for key, value in keys.items() if value > 0}

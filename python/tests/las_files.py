# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""LAS files with something in every place."""

from __future__ import annotations

import numpy as np
import pytest

laspy = pytest.importorskip("laspy", reason="NO LASPY: pip install deburr[las]")

WKT = 'LOCAL_CS["a town", UNIT["metre",1]]'


def make_las(version, point_format, points):
    """A file of laspy with a value in every dimension, an extra one, and a coordinate system."""
    header = laspy.LasHeader(version=version, point_format=point_format)
    header.offsets, header.scales = [500000, 5000000, 0], [0.001, 0.001, 0.001]
    header.add_extra_dim(laspy.ExtraBytesParams("reflectance", "f4", "in dB"))
    header.vlrs.append(laspy.vlrs.known.WktCoordinateSystemVlr(WKT))
    las = laspy.LasData(header)
    rng = np.random.default_rng(point_format)
    n = len(points)
    las.x, las.y, las.z = points.T * 5 + [[500000], [5000000], [100]]
    for name in las.point_format.dimension_names:
        if name in ("X", "Y", "Z"):
            continue
        if name == "gps_time":
            las[name] = 3e8 + rng.random(n)
        elif name == "reflectance":
            las[name] = rng.random(n)
        else:
            bits = las.point_format.dimension_by_name(name).num_bits
            las[name] = rng.integers(0, 2 ** min(bits, 15) - 1, n, endpoint=True) % 128
    if version == "1.4":
        las.evlrs = laspy.vlrs.vlrlist.VLRList(
            [laspy.VLR("a user", 77, "behind the points", b"\1\2\3" * 9)]
        )
    return las


def records(las):
    lists = [las.vlrs, las.evlrs or []]

    def data(vlr):  # laspy reads the records of COPC, but does not write them
        return b"" if vlr.user_id == "copc" else vlr.record_data_bytes()

    return [[(v.user_id, v.record_id, v.description, data(v)) for v in some] for some in lists]

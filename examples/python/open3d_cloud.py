# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""An Open3D cloud in, an Open3D cloud out: python open3d_cloud.py IN OUT."""

from __future__ import annotations

import sys

import open3d as o3d

import deburr


def main(source: str, target: str) -> None:
    noisy = o3d.io.read_point_cloud(source)
    result = deburr.denoise(noisy)
    clean = result.as_given()  # colours are those of the input
    print(f"{len(clean.points)} points moved by {result.rms_displacement:.4g} (rms)")
    edges = clean.select_by_index((result.labels == deburr.Feature.EDGE).nonzero()[0].tolist())
    print(f"{len(edges.points)} points on edges")
    o3d.io.write_point_cloud(target, clean)


if __name__ == "__main__":
    main(*sys.argv[1:3])

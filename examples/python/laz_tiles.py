# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Denoise a folder of LAZ tiles, each with its neighbours' points around it.

    python laz_tiles.py IN_FOLDER OUT_FOLDER --halo 5

A tile alone would have worse fits along its border. So each is denoised together with the points
of the other tiles within the halo, and only its own are written, with everything that they had.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import laspy
import numpy as np
from numpy.typing import NDArray

import deburr

Corner = NDArray[np.float64]


def bounds(path: Path) -> tuple[Corner, Corner]:
    """Corners of the box of a tile, as its header tells them."""
    with laspy.open(path) as tile:
        return np.array(tile.header.mins), np.array(tile.header.maxs)


def denoise_tile(path: Path, others: list[Path], halo: float) -> deburr.Result:
    """The result for the points of one tile."""
    tile = deburr.read(path)
    low, high = (corner[:2] for corner in bounds(path))
    around = []
    for other in others:
        least, most = (corner[:2] for corner in bounds(other))
        if np.any(most < low - halo) or np.any(least > high + halo):
            continue
        points = deburr.read(other).points
        flat = points[:, :2]
        around.append(points[np.all((flat >= low - halo) & (flat <= high + halo), axis=1)])
    together = deburr.denoise(np.concatenate([tile.points, *around]))
    return together.part(slice(len(tile)), tile)


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("source", type=Path)
    parser.add_argument("target", type=Path)
    parser.add_argument("--halo", type=float, default=5, help="in the unit of the tiles")
    arguments = parser.parse_args()
    arguments.target.mkdir(exist_ok=True)
    tiles = sorted(arguments.source.glob("*.laz"))
    for path in tiles:
        result = denoise_tile(path, [other for other in tiles if other != path], arguments.halo)
        deburr.write(arguments.target / path.name, result)
        print(f"{path.name}: {len(result)} points, moved by {result.rms_displacement:.3g} (rms)")


if __name__ == "__main__":
    main()

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""The suites that measure errors: given cases, and shapes at many levels of noise."""
import json

import numpy as np

from . import geometry, ply
from .program import Scan
from .rows import Row, geometric_mean

SHAPES = ["part", "cube", "sphere", "torus", "cylinder", "thin-plate", "bumpy-sheet",
          "stepped-wall"]


def cases(program, methods, args):
    """Mean error of every case of a folder against the noisy cloud and the best of other tools."""
    peers = json.loads(args.peers.read_text())["cases"]
    rows = []
    folders = sorted(p.parent for p in args.cases.glob("*/noisy.ply"))
    for folder in folders:
        clean = folder / "clean.ply"
        scan = Scan(folder.name, folder / "noisy.ply", folder / "truth.ply")
        before = program.compare(scan.noisy, scan)
        peer = peers.get(scan.name, {}).get("mean")
        for method, options in methods.items():
            out, _, seconds = program.denoise(scan.noisy, options)
            after = program.compare(out, scan)
            figures = {"points": before["count"], "noisy": 100 * before["mean_relative"],
                       "error": 100 * after["mean_relative"], "rms": 100 * after["rms_relative"],
                       "ratio": after["mean"] / before["mean"]}
            bars = {"ratio": ("<=", 1.0)}
            if peer:
                figures |= {"peer": peer, "peer_ratio": figures["error"] / peer}
                bars["peer_ratio"] = ("<=", 0.95)
            if clean.exists():
                figures["rms_to_clean"] = rms_to(clean, out, before["diagonal"])
            rows.append(Row("cases", scan.name, method, figures, bars, seconds))
            yield rows[-1]
    for method in methods:
        mine = [row for row in rows if row.method == method]
        for name, limit in (("ratio", 1.0), ("peer_ratio", 0.70)):
            mean = geometric_mean(row.figures.get(name) for row in mine)
            if mean is not None:
                yield Row("means", "geometric mean", method, {name: mean}, {name: ("<=", limit)})


def rms_to(clean, cloud, diagonal):
    """Root mean square distance of points from their own true places, in % of the diagonal."""
    move = ply.vectors(ply.read(cloud)[0]) - ply.vectors(ply.read(clean)[0])
    return 100 * float(np.sqrt((move ** 2).sum(axis=1).mean())) / diagonal


def noise_option(level):
    """'0.5' is in spacings, '1%' in hundredths of the diagonal."""
    if level.endswith("%"):
        return ["--noise", repr(float(level[:-1]) / 100)]
    return ["--noise-spacings", level]


def noise(program, methods, args):
    """Shapes x sizes x levels of noise: the error left, and how well the noise was estimated."""
    for points in args.points or [3000 if args.quick else 20000]:
        for shape in args.shapes:
            for level in args.noise:
                scan = program.synth(shape, points, *noise_option(level))
                before = program.compare(scan.noisy, scan)
                for method, options in methods.items():
                    out, told, seconds = program.denoise(scan.noisy, options)
                    after = program.compare(out, scan)
                    row = Row("noise", f"{shape} {points} at {level}", method, {}, {}, seconds)
                    row.plot = {"shape": shape, "points": points}
                    if scan.sigma == 0:
                        movement_of(row, out, scan, told)
                    else:
                        errors_of(row, before, after, scan, told)
                    yield row


def errors_of(row, before, after, scan, told):
    row.figures = {"sigma": scan.sigma / scan.spacing, "noisy": before["mean"] / scan.spacing,
                   "error": after["mean"] / scan.spacing, "ratio": after["mean"] / before["mean"],
                   "estimate": told["noise"] / scan.sigma}
    row.bars = {"ratio": ("<=", 1.0)}
    if 0.099 < scan.sigma / scan.spacing < 3.001:
        row.figures["estimate_off"] = abs(row.figures["estimate"] - 1)
        row.bars["estimate_off"] = ("<=", 0.15)


def movement_of(row, out, scan, told):
    """Without noise nothing should move."""
    clean = ply.vectors(ply.read(scan.clean)[0])
    move = np.linalg.norm(ply.vectors(ply.read(out)[0]) - clean, axis=1) / scan.spacing
    row.figures = {"sigma": 0, "move": float(move.mean()),
                   "estimate_spacings": told["noise"] / scan.spacing}
    row.bars = {"move": ("<=", 0.02), "estimate_spacings": ("<=", 0.02)}
    vertex, triangles = ply.read(scan.truth)
    edges = geometry.sharp_edges(ply.vectors(vertex), triangles)
    near = geometry.nearest_segment(clean, edges)[0] < 0.5 * scan.spacing
    if near.any():
        row.figures |= {"edge_move": float(move[near].mean()),
                        "edge_move_max": float(move[near].max())}
        row.bars["edge_move_max"] = ("<=", 0.10)

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""The suites that look at one property each: shape kept, sharpness, outliers, scale."""
import numpy as np

from . import geometry, ply
from .rows import Row


def shape(program, methods, args):
    """No shrinking, no sheet lost, no border that creeps."""
    points = 10000 if args.quick else 50000
    spheres = [(name, program.synth(name, points, "--noise", "0.01"))
               for name in ("sphere", "torus")]
    apart = 3  # spacings between the sheets
    plate = program.synth("thin-plate", points, "--noise-spacings", "0.3", "--thickness",
                          repr(apart / points ** 0.5))
    sheet = program.synth("bumpy-sheet", points, "--noise-spacings", "0.5")
    for method, options in methods.items():
        for name, scan in spheres:
            out, _, seconds = program.denoise(scan.noisy, options)
            told = program.compare(out, scan)
            offset = told["offset_mean"] / scan.sigma
            yield Row("shape", f"{name} {points} at 1%", method,
                      {"offset": offset, "offset_size": abs(offset)},
                      {"offset_size": ("<=", 0.05)}, seconds)
        out, _, seconds = program.denoise(plate.noisy, options)
        figures = gap_of(plate, out)
        figures["own_sheet"] = 1 - program.compare(out, plate)["offset_far_share"]
        yield Row("shape", f"thin-plate {points} at 0.3", method, figures,
                  {"own_sheet": (">=", 0.999), "gap_change": ("<=", 0.02)}, seconds)
        out, _, seconds = program.denoise(sheet.noisy, options)
        yield Row("shape", f"bumpy-sheet {points} at 0.5", method, border_of(sheet, out),
                  {"border_inwards": ("<=", 0.25)}, seconds)


def gap_of(scan, out):
    """How much the mean distance of the two sheets changed, as a share of it."""
    clean = ply.read(scan.clean)[0]
    up = clean["nz"] > 0
    gap = clean["z"][up].mean() - clean["z"][~up].mean()
    z = ply.vectors(ply.read(out)[0])[:, 2]
    left = z[up].mean() - z[~up].mean()
    return {"gap": float(left / gap), "gap_change": abs(float(left / gap) - 1)}


def border_of(scan, out):
    """Mean movement towards the inside of the points that belong at the border, in spacings."""
    clean = ply.vectors(ply.read(scan.clean)[0])
    vertex, triangles = ply.read(scan.truth)
    segments, inwards = geometry.border(ply.vectors(vertex), triangles)
    distance, which = geometry.nearest_segment(clean, segments)
    near = distance < 0.5 * scan.spacing
    move = (ply.vectors(ply.read(out)[0]) - clean)[near]
    along = np.einsum("ij,ij->i", move, inwards[which[near]])
    return {"border_points": int(near.sum()), "border_inwards": float(along.mean()) / scan.spacing}


def sharp(program, methods, args):
    """Edges and corners of the machined part."""
    points = 20000 if args.quick else 100000
    scan = program.synth("part", points, "--noise", "0.005")
    for method, options in methods.items():
        out, _, seconds = program.denoise(scan.noisy, options)
        told = program.compare(out, scan)
        names = ("edge_mean_ratio", "edge_recall", "edge_precision", "edge_point_recall",
                 "corner_recall", "corner_precision", "normal_error")
        yield Row("sharp", f"part {points} at 0.5%", method,
                  {name: told.get(name) for name in names},
                  {"edge_mean_ratio": ("<=", 1.5), "edge_recall": (">=", 0.90),
                   "edge_precision": (">=", 0.85), "corner_recall": (">=", 1)}, seconds)


def outliers(program, methods, args):
    """Outliers found, and good points taken for some."""
    if "--outliers" not in program.help:
        for method in methods:
            yield Row("outliers", "all", method, {},
                      note="this program has no option denoise --outliers")
        return
    points = 4000 if args.quick else 20000
    for name in args.shapes:
        for level in ("0", "0.0025", "0.005", "0.01"):
            clean = program.synth(name, points, "--noise", level)
            dirty = program.synth(name, points, "--noise", level, "--outliers", "0.05",
                                  "--cluster-outliers", "0.02")
            truth = ply.read(dirty.clean)[0]["outlier"] != 0
            distance = program.distances(dirty)
            for method, options in methods.items():
                row = Row("outliers", f"{name} {points} at {100 * float(level):g}%", method, {})
                out, _, row.seconds = program.denoise(dirty.noisy, options + " --outliers label")
                flagged = flags(out)
                out, _, _ = program.denoise(clean.noisy, options + " --outliers label")
                clean_flagged = flags(out)
                if flagged is None or clean_flagged is None:
                    row.note = "denoise --outliers label wrote no field deburr_outlier"
                else:
                    row.figures = found(flagged, truth, distance, dirty.sigma)
                    row.figures["false_share"] = float(clean_flagged.mean())
                    row.bars = {"recall": (">=", 0.95), "precision": (">=", 0.95),
                                "recall_off": (">=", 0.95), "false_share": ("<=", 0.005)}
                yield row


def flags(file):
    fields = ply.read(file)[0]
    return fields["deburr_outlier"] != 0 if "deburr_outlier" in fields.dtype.names else None


def found(flagged, truth, distance, sigma):
    """Recall and precision, and what distances from the true surface say of them."""
    off = truth & (distance > 3 * sigma)
    # Thresholds from the farthest point on: outliers and all points beyond each.
    hits = np.cumsum(truth[np.argsort(-distance)])
    best = np.minimum(hits / truth.sum(), hits / np.arange(1, len(hits) + 1)).max()
    figures = {"recall": (flagged & truth).sum() / truth.sum(),
               "precision": (flagged & truth).sum() / max(1, flagged.sum()),
               "recall_off": (flagged & off).sum() / off.sum(), "reachable": best}
    return {name: float(value) for name, value in figures.items()}


def scale(program, methods, args):
    """The same result in any unit and far from the origin."""
    points = 2000 if args.quick else 10000
    scan = program.synth("part", points, "--noise", "0.005")
    base = ply.vectors(ply.read(scan.noisy)[0])
    far = 1e7 * scan.spacing * np.array([1, -1, 1])
    rounded = (base + far) - far  # what is left of the input there
    changes = [("x 1e-6", base, 1e-6, 0), ("x 1e6", base, 1e6, 0),
               ("+ 1e7 spacings", rounded, 1, far)]
    file = program.folder / "changed.ply"
    for method, options in methods.items():
        for name, reference, factor, shift in changes:
            results, seconds = [], 0
            for cloud in (reference, factor * reference + shift):
                ply.write_points(file, cloud)
                out, _, seconds = program.denoise(file, options)
                results.append(ply.vectors(ply.read(out)[0]))
            difference = np.linalg.norm((results[1] - shift) / factor - results[0], axis=1)
            yield Row("scale", f"part {points} {name}", method,
                      {"difference": float(difference.max()) / scan.spacing,
                       "moved_otherwise": int((difference > 1e-6 * scan.spacing).sum())},
                      {"difference": ("<=", 1e-6)}, seconds)

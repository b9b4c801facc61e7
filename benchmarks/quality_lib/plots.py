# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Plots of what was measured: error against noise, estimated noise, and errors of the cases."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402, the backend comes first


def draw(rows, folder):
    """Writes what the rows allow, and returns the names of the files."""
    written = []
    noise = [row for row in rows if row.suite == "noise" and row.figures["sigma"] > 0]
    for points in sorted({row.plot["points"] for row in noise}):
        mine = [row for row in noise if row.plot["points"] == points]
        for key, label, noisy in (("error", "mean error, spacings", True),
                                  ("estimate", "estimated / true noise", False)):
            name = f"{key}_{points}.png"
            against_noise(mine, key, label, noisy, f"{points} points", folder / name)
            written.append(name)
    given = [row for row in rows if row.suite == "cases"]
    if given:
        cases(given, folder / "cases.png")
        written.append("cases.png")
    return written


def against_noise(rows, key, label, noisy, title, path):
    shapes = list(dict.fromkeys(row.plot["shape"] for row in rows))
    across = min(4, len(shapes))
    down = -(-len(shapes) // across)
    figure, axes = plt.subplots(down, across, figsize=(3.4 * across, 3 * down), squeeze=False,
                                sharex=True, sharey=True, layout="constrained")
    for axis, shape in zip(axes.flat, shapes):
        mine = sorted((row for row in rows if row.plot["shape"] == shape),
                      key=lambda row: row.figures["sigma"])
        for method in dict.fromkeys(row.method for row in mine):
            of = [row.figures for row in mine if row.method == method]
            axis.plot([f["sigma"] for f in of], [f[key] for f in of], ".-", label=method)
        if noisy:
            axis.plot([f["sigma"] for f in of], [f["noisy"] for f in of], "k--", label="noisy")
            axis.set_yscale("log")
        else:
            axis.axhspan(0.85, 1.15, color="0.9")
        axis.set_xscale("log")
        axis.set_title(shape)
        axis.grid(alpha=0.3)
    for axis in axes.flat[len(shapes):]:
        axis.axis("off")
    figure.suptitle(title)
    figure.supxlabel("noise, spacings")
    figure.supylabel(label)
    axes.flat[0].legend()
    figure.savefig(path, dpi=110)
    plt.close(figure)


def cases(rows, path):
    names = list(dict.fromkeys(row.case for row in rows))
    methods = list(dict.fromkeys(row.method for row in rows))
    figure, axis = plt.subplots(figsize=(9, 0.5 * len(names) + 1.5), layout="constrained")
    height = 0.8 / len(methods)
    for k, method in enumerate(methods):
        ratio = [next(r.figures["ratio"] for r in rows if (r.case, r.method) == (name, method))
                 for name in names]
        axis.barh([i + (k - (len(methods) - 1) / 2) * height for i in range(len(names))], ratio,
                  height, label=method)
    of = [next(r.figures for r in rows if r.case == name) for name in names]
    peers = [(f["peer"] / f["noisy"], i) for i, f in enumerate(of) if f.get("peer")]
    if peers:
        axis.plot(*zip(*peers), "k|", markersize=26, markeredgewidth=2, label="best peer")
    axis.axvline(1, color="0.6", linestyle="--")
    axis.set_yticks(range(len(names)), names)
    axis.invert_yaxis()
    axis.set_xlabel("mean error / that of the noisy cloud")
    axis.legend()
    figure.savefig(path, dpi=110)
    plt.close(figure)

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""How near the main loops come to what the machine can do."""
from speed_lib.runs import Run, in_turns, spread

# Operations in double precision for a pair of neighbours in a round of yadav2018, all in
# src/neighbor_sums.cpp (add_all): difference 3, cosine 5, count 1, sum 6, two outer products 30,
# turn 3, two squares 10, exponent 3, its power 37, offset 5, weighted sums 3.
ROUND_FLOPS = 106
# Bytes for a pair: its index in the list of the block. For a point: where its list is, its first
# place, its place and normal and the new ones; and the rows of what a block sees, points of their
# own and around, about 1.7 for each of its points.
ROUND_BYTES_PAIR = 2
ROUND_BYTES_POINT = 8 + 24 + 4 * 24 + 1 + 1.7 * 48

# Of a search: difference 3, square 5, for every candidate; all are looked at twice, to count and
# to find. There are 9 squares of cells where a disc of pi of them is wanted.
CANDIDATES = 9 / 3.14159
SEARCH_FLOPS = 2 * 8 * CANDIDATES
# Candidates of one point are those of the next, and stay in the cache. What is found is written,
# and read from memory to be written.
SEARCH_BYTES_PAIR = 8
SEARCH_BYTES_POINT = 2 * 24 + 3 * 8


def per_second(run):
    return run.printed["number"] / run.cpu


def line(name, runs, flops, moved, peak, bandwidth):
    """One loop: what it does in a second, and the larger of the shares of both roofs."""
    seconds = [run if isinstance(run, float) else run.cpu for run in runs]
    best = max(flops / peak, moved / bandwidth)
    roof = "arithmetic" if flops / peak > moved / bandwidth else "memory"
    print(f"    {name}: {flops / 1e9:.2f}e9 operations, {moved / 1e9:.3f}e9 bytes, "
          f"{flops / moved:.1f} for each; {spread([flops / s / 1e9 for s in seconds])}e9 and "
          f"{spread([moved / s / 1e9 for s in seconds])}e9 a second; "
          f"{spread([best / s for s in seconds])} of the roof, which is {roof}")


def roofline(bench):
    machine = in_turns({what: [bench.built["machine"], what] for what in ("bandwidth", "flops")},
                       max(3, bench.args.runs))
    bandwidth = max(map(per_second, machine["bandwidth"]))
    peak = max(map(per_second, machine["flops"]))
    points = bench.args.points
    print(f"roofline, one core: {bandwidth / 1e9:.1f}e9 bytes a second (triad), {peak / 1e9:.1f}e9 "
          "multiplications and additions, not fused (the best of the runs)")
    for noise in bench.noises:
        scan, spacing, _ = bench.scan(points, noise)
        print(f"  noise {noise}")
        search = in_turns({"": [bench.built["stages"], "neighbors", scan, 3.5 * spacing, 1]},
                          bench.args.runs)[""]
        pairs = search[0].printed["number"]
        line(f"search, {pairs / points:.0f} neighbours", search, SEARCH_FLOPS * pairs,
             SEARCH_BYTES_PAIR * pairs + SEARCH_BYTES_POINT * points, peak, bandwidth)
        # The neighbours of yadav2018: 5 times its spacing, which the report tells.
        some = ["--method", "yadav2018", "--update", "simultaneous", "--threads", 1, "--rounds"]
        runs = in_turns({n: bench.denoise(scan, *some, n) for n in (1, 6)}, bench.args.runs)
        radius = 5 * runs[1][0].printed["spacing"]
        pairs = Run([bench.built["stages"], "neighbors", scan, radius, 1]).printed["number"]
        rounds = [(b.cpu - a.cpu) / 5 for a, b in zip(runs[1], runs[6])]
        line(f"a round of yadav2018 at once, {pairs / points:.0f} neighbours", rounds,
             ROUND_FLOPS * pairs, ROUND_BYTES_PAIR * pairs + ROUND_BYTES_POINT * points, peak,
             bandwidth)

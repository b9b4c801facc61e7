# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What each ingredient of the default method contributes: errors without it over errors with all.

benchmarks/ablation.cpp says what can be left out.
"""
import subprocess
import sys

from .program import ROOT, Scan
from .rows import geometric_mean, markdown

FILE = ROOT / "build/ablation/benchmarks/ablation"
BUILD = """. scripts/common.sh; start_log ablation
install_missing "${build_packages[@]}" libbenchmark-dev
logged cmake --preset release -B build/ablation -DDEBURR_BUILD_BENCHMARKS=ON &&
logged cmake --build build/ablation --target ablation -j "$(nproc)" ||
fail_with_log "the build failed"
"""
POINTS = 20000
COMPLETE = "nothing"


def build():
    if subprocess.run(["bash", "-euc", BUILD], cwd=ROOT, check=False).returncode:
        sys.exit("quality: ablation could not be built; CONTRIBUTING.md tells how to build")


def output(*arguments):
    ran = subprocess.run([FILE, *arguments], capture_output=True, text=True, check=False)
    if ran.returncode:
        sys.exit(f"quality: ablation ended with {ran.returncode}: {ran.stderr.strip()}")
    return ran.stdout


def scans(program, args):
    """Name, scan and figure of every column."""
    for folder in sorted(p.parent for p in args.cases.glob("*/noisy.ply")) if args.cases else []:
        scan = Scan(folder.name, folder / "noisy.ply", folder / "truth.ply")
        yield folder.name, scan, "mean_relative"
    for figure, name in (("mean_relative", "part"), ("edge_mean_relative", "part, by edges")):
        yield name, program.synth("part", POINTS, "--noise", "0.005"), figure


def errors(program, args):
    """For every part left out the error of every column, in % of the diagonal."""
    columns = list(scans(program, args))
    out, told = program.folder / "without.ply", {}
    for part in output("--list").splitlines():
        of_scan = {}
        for _, scan, _ in columns:
            if scan.noisy not in of_scan:
                output(part, scan.noisy, out)
                of_scan[scan.noisy] = program.compare(out, scan)
        told[part] = [100 * of_scan[scan.noisy][figure] for _, scan, figure in columns]
        print(f"without {part}: {' '.join(f'{error:.4f}' for error in told[part])}", flush=True)
    return [name for name, _, _ in columns], told


def table(program, args):
    """A row for each part left out; the geometric mean is that of the given cases."""
    names, told = errors(program, args)
    cases = len(list(args.cases.glob("*/noisy.ply"))) if args.cases else 0
    lines = []
    for part, row in told.items():
        ratios = [error / whole for error, whole in zip(row, told[COMPLETE])]
        shown = row if part == COMPLETE else ratios
        mean = geometric_mean(shown[:cases])
        cells = [f"{value:.4f}" if part == COMPLETE else f"{value:.2f}" for value in shown]
        cells.insert(cases, mean and f"{mean:.4f}" if part == COMPLETE else mean and f"{mean:.3f}")
        lines.append([f"**{part}** (error)" if part == COMPLETE else part, *cells])
    return markdown(["left out", *names[:cases], "geometric mean", *names[cases:]], lines)

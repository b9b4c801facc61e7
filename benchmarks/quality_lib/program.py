# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the program deburr and keeps the scans that it synthesises."""
import json
import pathlib
import shlex
import subprocess
import sys
import time

from . import ply

ROOT = pathlib.Path(__file__).resolve().parents[2]
DEFAULT = ROOT / "build/release/deburr"
BUILD = ('. scripts/common.sh; start_log quality; install_missing "${build_packages[@]}"; '
         "build_preset release")


class Scan:
    """Files of a scan, and what deburr synth told of it (spacing, sigma)."""

    def __init__(self, name, noisy, truth, clean=None, spacing=None, sigma=None):
        self.name, self.noisy, self.truth, self.clean = name, noisy, truth, clean
        self.spacing, self.sigma = spacing, sigma


class Program:
    """The program, a folder for its files, and the options that all of its runs get."""

    def __init__(self, path, folder, threads, seed):
        self.path, self.folder = pathlib.Path(path), pathlib.Path(folder)
        self.threads, self.seed = threads, seed
        if not self.path.exists():
            if self.path != DEFAULT:
                sys.exit(f"quality: no such program: {self.path}")
            if subprocess.run(["bash", "-euc", BUILD], cwd=ROOT, check=False).returncode:
                sys.exit("quality: the program could not be built; CONTRIBUTING.md tells how to")
        self.version = self.output("--version").strip()
        self.help = self.output("denoise", "--help")
        self.scans, self.truths = {}, {}

    def output(self, *arguments):
        ran = subprocess.run([str(self.path), *map(str, arguments)], capture_output=True,
                             text=True, check=False)
        if ran.returncode:
            command = shlex.join(map(str, arguments))
            sys.exit(f"quality: deburr {command} ended with {ran.returncode}: {ran.stderr.strip()}")
        return ran.stdout

    def run(self, *arguments):
        """The JSON object that a command prints."""
        return json.loads(self.output(*arguments, "--json", "--quiet", "--threads", self.threads))

    def synth(self, shape, points, *options):
        """A scan of a shape. The same call again costs nothing."""
        key = (shape, points, options)
        if key not in self.scans:
            at = self.folder / f"scan{len(self.scans)}"
            thickness = options[options.index("--thickness") + 1] if "--thickness" in options else 0
            truth = self.truths.get((shape, thickness))
            extra = []
            if not truth:
                truth = self.truths[shape, thickness] = at.with_suffix(".truth.ply")
                extra = ["--truth", truth]
            noisy, clean = at.with_suffix(".ply"), at.with_suffix(".clean.ply")
            told = self.run("synth", shape, noisy, "--points", points, "--clean", clean,
                            "--seed", self.seed, *extra, *options)
            self.scans[key] = Scan(shape, noisy, truth, clean, told["spacing"], told["sigma"])
        return self.scans[key]

    def denoise(self, noisy, options):
        """Result file, what the program told, and wall seconds, of a method's option string."""
        out = self.folder / "denoised.ply"
        start = time.perf_counter()
        told = self.run("denoise", noisy, out, *shlex.split(options))
        return out, told, time.perf_counter() - start

    def distances(self, scan):
        """Distance of every noisy point of a scan from its true surface."""
        out = self.folder / "distances.ply"
        self.compare(scan.noisy, scan, "--distances", out)
        return ply.read(out)[0]["deburr_distance"]

    def compare(self, cloud, scan, *options):
        """Figures of a cloud against the truth of a scan."""
        clean = ["--clean", scan.clean] if scan.clean else []
        return self.run("compare", cloud, "--truth", scan.truth, *clean, "--samples", 0, *options)

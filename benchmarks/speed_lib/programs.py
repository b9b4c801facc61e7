# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Builds what benchmarks/speed compares."""
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
RELEASE = ROOT / "build/release"
FLAGS = ["-O3", "-DNDEBUG"]
PACKAGES = ["libnanoflann-dev", "libcgal-dev", "libpcl-dev"]
BUILD = ('. scripts/common.sh; start_log speed; install_missing "${build_packages[@]}"; '
         "build_preset release")


def compiler():
    for line in (RELEASE / "CMakeCache.txt").read_text().splitlines():
        if line.startswith("CMAKE_CXX_COMPILER:"):
            return line.split("=", 1)[1]
    return "c++"


def pcl_flags():
    """Compiler and linker flags of PCL, none if it is not there."""
    headers = sorted(pathlib.Path("/usr/include").glob("pcl-*"))
    if not headers:
        return None
    return [f"-I{headers[-1]}", "-I/usr/include/eigen3", "-Wno-deprecated", "-lpcl_surface",
            "-lpcl_search", "-lpcl_kdtree", "-lpcl_common", "-lboost_system"]


def compile_one(name, folder, standard, flags):
    """Path of a program of benchmarks/peers, compiled; None where it cannot be."""
    source = ROOT / f"benchmarks/peers/{name}.cpp"
    program = folder / name
    command = [compiler(), f"-std=c++{standard}", *FLAGS, str(source), "-o", str(program), *flags]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    if ran.returncode:
        (folder / f"{name}.log").write_text(" ".join(command) + "\n" + ran.stderr)
        return None
    return program


def build():
    """Name -> path of deburr, its stages, and those peers whose packages are installed."""
    if subprocess.run(["bash", "-euc", BUILD], cwd=ROOT, check=False).returncode:
        sys.exit("speed: deburr could not be built; CONTRIBUTING.md tells how to")
    folder = ROOT / "build/speed"
    os.makedirs(folder, exist_ok=True)
    library = [f"-I{ROOT}/include", f"-I{RELEASE}/generated", str(RELEASE / "libdeburr.a"),
               "-ltbb", "-lfmt"]
    programs = {"deburr": RELEASE / "deburr",
                "stages": compile_one("stages", folder, 20, library)}
    programs["machine"] = compile_one("machine", folder, 20,
                                      ["-ffp-contract=off", "-Wno-psabi"])
    for name in ("stages", "machine"):
        if not programs[name]:
            sys.exit(f"speed: {name} does not compile; see {folder}/{name}.log")
    wanted = {
        "nanoflann": (pathlib.Path("/usr/include/nanoflann.hpp").exists(), 17, []),
        "cgal": (pathlib.Path("/usr/include/CGAL/jet_smooth_point_set.h").exists(), 17,
                 ["-DCGAL_EIGEN3_ENABLED", "-I/usr/include/eigen3", "-lgmp", "-lmpfr"]),
        "pcl": (pcl_flags() is not None, 17, pcl_flags() or [])}
    for (name, (there, standard, flags)), package in zip(wanted.items(), PACKAGES):
        programs[name] = compile_one(name, folder, standard, flags) if there else None
        if not there:
            print(f"SKIPPED {name}: not installed. apt-get install --no-install-recommends "
                  f"{package}")
        elif not programs[name]:
            print(f"SKIPPED {name}: it does not compile; see {folder}/{name}.log")
    return programs

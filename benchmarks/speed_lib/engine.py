# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Tables of benchmarks/speed about deburr alone: scaling, memory, stages, instructions."""
import re
import subprocess
import sys

from speed_lib.runs import cpu, in_turns, spread

METHODS = {"default": [],
           "yadav2018, at once": ["--method", "yadav2018", "--update", "simultaneous"],
           "yadav2018, in place": ["--method", "yadav2018"]}


def times_fewer(options, rounds):
    """The options of a method, with so many rounds if it has any."""
    return [*options, "--rounds", rounds] if "yadav2018" in options else options


def scaling(bench):
    """CPU time of four times as many points, and wall time of two threads."""
    few, many = bench.args.points, 4 * bench.args.points
    print(f"scaling: {few} against {many} points, and 1 against 2 threads; yadav2018 with 5 rounds")
    for noise in bench.noises:
        for name, options in METHODS.items():
            commands = {}
            for points in (few, many):
                scan = bench.scan(points, noise)[0]
                for threads in (1, 2) if "in place" not in name else (1,):
                    commands[points, threads] = bench.denoise(
                        scan, *times_fewer(options, 5), "--threads", threads)
            runs = in_turns(commands, bench.args.runs)
            line = f"  noise {noise}, {name}: 4 times the points take " + spread(
                [b.cpu / a.cpu for a, b in zip(runs[few, 1], runs[many, 1])]) + " times as long"
            if (few, 2) in runs:
                for points in (few, many):
                    line += f"; of {points} 2 threads are " + spread(
                        [a.core / b.core for a, b in zip(runs[points, 1], runs[points, 2])]
                    ) + " times as fast"
            print(line)
    print("  wall time without reading and writing, CPU time with them")


def memory(bench):
    """Peak memory beyond the input."""
    print("peak memory of the process beyond the points of the input, bytes for each of them; "
          "yadav2018 with 2 rounds")
    for noise in bench.noises:
        for points in (bench.args.points, 4 * bench.args.points):
            scan = bench.scan(points, noise)[0]
            runs = in_turns({name: bench.denoise(scan, *times_fewer(options, 2), "--threads", 1)
                             for name, options in METHODS.items()}, 1)
            bytes_each = ", ".join(f"{name} {(run[0].memory / points) - 24:.0f}"
                                   for name, run in runs.items())
            print(f"  noise {noise}, {points} points: {bytes_each}")


def stages(bench):
    """Where the time goes."""
    print("wall time of each stage, one thread: seconds, and microseconds for each point")
    for noise in bench.noises:
        scan = bench.scan(bench.args.points, noise)[0]
        for name, options in METHODS.items():
            runs = in_turns({"": bench.denoise(scan, *options, "--threads", 1)},
                            bench.args.runs)[""]
            print(f"  noise {noise}, {name}")
            for k, stage in enumerate(runs[0].printed["stages"]):
                seconds = [run.printed["stages"][k]["seconds"] for run in runs]
                each = 1e6 * sorted(seconds)[len(seconds) // 2] / bench.args.points
                print(f"    {stage['stage']:24} {spread(seconds)} s, {each:.2f}")


def instructions(bench):
    """Instruction counts, which no other work on the machine can change."""
    points = min(bench.args.points, 100000)
    print(f"instructions under callgrind, {points} points, one thread, files read and written; "
          "yadav2018 with 5 rounds (valgrind knows AVX2, not AVX-512)")
    valgrind = subprocess.run(["valgrind", "--version"], capture_output=True, check=False)
    if valgrind.returncode:
        sys.exit("speed: no valgrind. apt-get install --no-install-recommends valgrind")
    out = bench.folder / "callgrind.out"
    for noise in bench.noises:
        scan = bench.scan(points, noise)[0]
        for name, options in METHODS.items():
            command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}",
                       *bench.denoise(scan, *times_fewer(options, 5), "--threads", 1)]
            ran = subprocess.run([str(c) for c in command], capture_output=True, text=True,
                                 check=True)
            count = int(re.search(r"Collected : (\d+)", ran.stderr)[1])
            plain = in_turns({"": command[3:]}, bench.args.runs)[""]
            print(f"  noise {noise}, {name}: {count / 1e9:.2f} billion, "
                  f"{count / points:.0f} for each point; {spread([1e9 * c / count for c in cpu(plain)], 3)} "
                  "nanoseconds each in a run without callgrind")
            for share, function in largest(out):
                print(f"    {share:5.1f} %  {function}")


def largest(out, number=6):
    """Share and name of the functions with most instructions of their own."""
    told = subprocess.run(["callgrind_annotate", out], capture_output=True, text=True,
                          check=True).stdout
    found = []
    for line in told.splitlines():
        match = re.match(r"\s*[\d,]+ \(\s*([\d.]+)%\)\s+(?:[^:]*:)?(.+?)(?: \[.*)?$", line)
        if match and "PROGRAM TOTALS" not in line:
            name = re.sub(r"\(.*", "", match[2].replace("(anonymous namespace)::", ""))
            found.append((float(match[1]), name[-90:]))
    return found[:number]

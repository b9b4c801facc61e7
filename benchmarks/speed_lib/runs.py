# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Runs programs one after the other, in turns, and says what they took."""
import json
import os
import statistics
import subprocess
import sys
import tempfile


class Run:
    """Processor and wall time in seconds, peak memory in bytes, and what was printed."""

    def __init__(self, command):
        with tempfile.TemporaryFile() as printed:
            process = subprocess.Popen([str(c) for c in command], stdout=printed)
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            printed.seek(0)
            text = printed.read().decode()
        if process.returncode:
            sys.exit(f"speed: {' '.join(map(str, command))} ended with {process.returncode}")
        self.printed = json.loads(text) if text.startswith("{") else {}
        # The clock of a program's own leaves out reading and writing.
        self.cpu = self.printed.get("cpu", usage.ru_utime + usage.ru_stime)
        self.wall = self.printed.get("wall", sum(s["seconds"] for s in
                                                 self.printed.get("stages", [])))
        # The same without reading and writing, where a program tells.
        self.core = sum(stage["seconds"] for stage in self.printed.get("stages", [])
                        if stage["stage"] not in ("read", "write"))
        self.memory = usage.ru_maxrss * 1024


def in_turns(commands, times):
    """Runs every command so many times: A, B, A, B, ... Name -> its runs."""
    runs = {name: [] for name in commands}
    for _ in range(times):
        for name, command in commands.items():
            runs[name].append(Run(command))
    return runs


def spread(values, digits=2):
    """Median [minimum, maximum]."""
    middle = statistics.median(values)
    return f"{middle:.{digits}f} [{min(values):.{digits}f}, {max(values):.{digits}f}]"


def cpu(runs):
    return [run.cpu for run in runs]


def ratio(ours, theirs):
    """Of the runs of each turn, how many times as long theirs took."""
    return spread([b.cpu / a.cpu for a, b in zip(ours, theirs)])

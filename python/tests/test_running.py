# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""While the library works: progress, cancelling, Ctrl-C, the GIL."""

from __future__ import annotations

import _thread
import threading
import time

import numpy as np
import pytest

import deburr


@pytest.fixture(scope="module")
def points():
    return deburr.synth("part", points=3000).cloud.points


def test_progress_never_goes_back(points):
    calls = []
    deburr.denoise(points, on_progress=lambda stage, fraction: calls.append((stage, fraction)))
    fractions = [fraction for _, fraction in calls]
    assert len(calls) > 5
    assert fractions == sorted(fractions)
    assert 0 <= fractions[0] <= fractions[-1] <= 1
    assert all(isinstance(stage, str) for stage, _ in calls)
    assert len({stage for stage, _ in calls}) > 2


def test_progress_does_not_change_the_result(points):
    told = deburr.denoise(points, on_progress=lambda *_: None)
    assert np.array_equal(told.points, deburr.denoise(points).points)


class EnoughError(Exception):
    pass


@pytest.mark.parametrize(
    "function",
    [
        deburr.denoise,
        deburr.find_outliers,
        lambda points, on_progress: deburr.find_neighbors(
            points, max_count=8, on_progress=on_progress
        ),
        lambda _, on_progress: deburr.synth(
            points=5000, sampling="poisson", on_progress=on_progress
        ),
    ],
    ids=["denoise", "find_outliers", "find_neighbors", "synth"],
)
def test_what_progress_raises_stops_the_work(points, function):
    calls = []

    def stop(stage, fraction):
        calls.append((stage, fraction))
        raise EnoughError("stop")

    with pytest.raises(EnoughError, match="stop"):
        function(points, on_progress=stop)
    assert len(calls) == 1


def test_interrupt_stops_the_work():
    many = deburr.synth("part", points=60000).cloud.points
    working = threading.Event()

    def interrupt():
        working.wait()
        time.sleep(0.1)  # so that it comes while the library works
        _thread.interrupt_main()

    helper = threading.Thread(target=interrupt)
    helper.start()
    told = []

    def progress(_, fraction):
        # Only once, so that it is the library that has to look for signals.
        if not told:
            told.append(fraction)
            working.set()

    with pytest.raises(KeyboardInterrupt):
        deburr.denoise(many, on_progress=progress)
    helper.join()


def test_other_threads_run_meanwhile(points):
    done = threading.Event()
    results = []

    def work():
        results.append(deburr.denoise(points, threads=1))
        done.set()

    worker = threading.Thread(target=work)
    worker.start()
    turns = 0
    while not done.is_set():
        turns += 1
    worker.join()
    assert results
    # With the GIL held there are a few turns before the work begins.
    assert turns > 20000

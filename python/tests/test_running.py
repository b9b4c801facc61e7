# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""While the library works: progress, cancelling, Ctrl-C, the GIL."""

from __future__ import annotations

import _thread
import signal
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


class Record(dict):
    """How far a call has come. Its progress function is one of C: it runs no line of Python, at
    which the interpreter would look for signals or let other threads run."""

    @property
    def progress(self):
        return super().__setitem__

    def fraction(self):
        return max([*self.values()], default=0.0)


def test_interrupt_stops_the_work():
    many = deburr.synth("part", points=60000).cloud.points
    record = Record()

    def interrupt():
        while not record:
            time.sleep(0.01)
        _thread.interrupt_main()

    sender = threading.Thread(target=interrupt)
    sender.start()
    # Where the tests run in the background, Ctrl-C is ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            deburr.denoise(many, on_progress=record.progress)
        sender.join()
    finally:
        signal.signal(signal.SIGINT, before)
    assert record.fraction() < 0.9


def test_other_threads_run_meanwhile(points):
    record, done = Record(), threading.Event()

    def work():
        deburr.denoise(points, threads=1, on_progress=record.progress)
        done.set()

    worker = threading.Thread(target=work)
    worker.start()
    seen = set()
    while not done.is_set():
        seen.add(record.fraction())
    worker.join()
    # With the GIL held there would be nothing to see but the beginning and the end.
    assert len(seen) > 4

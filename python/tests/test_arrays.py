# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import gc

import numpy as np
import pytest

import deburr


@pytest.fixture(scope="module")
def points():
    return deburr.synth("cube", points=600).cloud.points


@pytest.fixture(scope="module")
def expected(points):
    return deburr.denoise(points).points


def fields_of_a_record(points):
    table = np.zeros(len(points), dtype=[("id", "u1"), ("xyz", "f8", 3)])
    table["xyz"] = points
    return table["xyz"]


def wide_table(points):
    table = np.zeros((len(points), 7))
    table[:, 1:6:2] = points
    return table[:, 1:6:2]


@pytest.mark.parametrize(
    "shape",
    [
        np.asfortranarray,
        wide_table,
        fields_of_a_record,
        lambda points: points[::-1].copy()[::-1],
        lambda points: points.astype(">f8"),
        lambda points: points.tolist(),
    ],
    ids=["fortran", "columns", "unaligned", "backwards", "big endian", "lists"],
)
def test_any_memory_gives_the_same_bits(points, expected, shape):
    assert np.array_equal(deburr.denoise(shape(points)).points, expected)


def test_read_only_input(points, expected):
    locked = points.copy()
    locked.flags.writeable = False
    result = deburr.denoise(locked, normals=locked)
    assert np.array_equal(deburr.denoise(locked).points, expected)
    assert result.points.flags.writeable
    assert deburr.find_outliers(locked).shape == (len(points),)


def test_float32_comes_back_where_it_is_fine_enough(points):
    single = points.astype(np.float32)
    result = deburr.denoise(single)
    assert result.points.dtype == np.float32
    exact = deburr.denoise(single.astype(np.float64)).points
    assert np.array_equal(result.points, exact.astype(np.float32))
    far = deburr.denoise((points + 5e6).astype(np.float32))
    assert far.points.dtype == np.float64


@pytest.mark.parametrize("dtype", [np.int32, np.float16, np.longdouble, bool])
def test_other_numbers_become_float64(dtype):
    grid = np.stack(np.meshgrid(*[np.arange(3)] * 3), axis=-1).reshape(-1, 3).astype(dtype)
    result = deburr.denoise(grid)
    assert result.points.dtype == np.float64
    assert np.array_equal(result.points, grid)


@pytest.mark.parametrize(
    ("bad", "error", "words"),
    [
        (np.zeros(9), ValueError, "points must have shape (N, 3), got (9,)"),
        (np.zeros((4, 2)), ValueError, "points must have shape (N, 3), got (4, 2)"),
        (np.zeros((2, 3, 3)), ValueError, "points must have shape (N, 3), got (2, 3, 3)"),
        (np.zeros((4, 3), complex), TypeError, "points must hold numbers"),
        ([["a", "b", "c"]], TypeError, "points must hold numbers"),
        (None, TypeError, "points must hold numbers"),
    ],
)
def test_what_is_no_array_of_points(bad, error, words):
    for function in (deburr.denoise, deburr.measure_noise, deburr.find_outliers):
        with pytest.raises(error) as caught:
            function(bad)
        assert words in str(caught.value)


def test_results_own_their_memory(points):
    def parts():
        result = deburr.denoise(points.copy())
        near = deburr.find_neighbors(points, max_count=4)
        return result.points, result.labels, near[5], deburr.estimate_normals(points, near)

    kept = parts()
    copies = [array.copy() for array in kept]
    gc.collect()
    _ = [np.full((len(points), 3), 7.0) for _ in range(8)]
    for array, copy in zip(kept, copies, strict=True):
        assert np.array_equal(array, copy)
        array[:] = 0  # writable, and of no one else


def test_threads_of_python_do_not_disturb_each_other(points, expected):
    from concurrent.futures import ThreadPoolExecutor

    with ThreadPoolExecutor(3) as pool:
        results = list(pool.map(lambda _: deburr.denoise(points, threads=1).points, range(3)))
    assert all(np.array_equal(result, expected) for result in results)

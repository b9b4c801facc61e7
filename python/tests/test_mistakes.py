# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What is easily got wrong is answered with what to do, and what is easily tried works."""

from __future__ import annotations

import numpy as np
import pytest
from stand_ins import LegacyCloud, Vectors

import deburr

POINTS = np.random.default_rng(3).random((40, 3))

MISTAKES = {
    "a path": (lambda: deburr.denoise("scan.ply"), TypeError, r"got 'scan.ply': deburr.read\(\)"),
    "nothing": (lambda: deburr.denoise(None), TypeError, "got NoneType"),
    "rows": (lambda: deburr.denoise(POINTS.T[:, :9]), ValueError, r"\(3, 9\), is it transposed\?"),
    "a slice": (lambda: deburr.PointCloud(POINTS)[1:3], TypeError, "take() chooses"),
    "no mesh": (
        lambda: deburr.metrics.compare_to_surface(POINTS, POINTS),
        TypeError,
        "surface must be a TriangleMesh, got ndarray",
    ),
    "threads": (
        lambda: deburr.metrics.compare_to_cloud(POINTS, POINTS, threads="all"),
        TypeError,
        "threads must be an integer, got 'all'",
    ),
    "an extension": (
        lambda: deburr.write("x.docx", POINTS),
        ValueError,
        r"one of \.ply .*\.laz \.copc\.laz \.e57, got 'x.docx'",
    ),
    "to write nothing": (lambda: deburr.write("x.ply", None), TypeError, "got NoneType"),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistake(name):
    call, error, message = MISTAKES[name]
    with pytest.raises(error, match=message.replace("take()", r"take\(\)")):
        call()


def test_results_are_arrays_and_clouds(scan, result):
    assert np.array_equal(np.asarray(result), result.points)
    again = deburr.denoise(result)
    assert again.report.kept_normals
    assert np.array_equal(again.points, deburr.denoise(result.to_cloud()).points)
    assert np.array_equal(deburr.denoise(scan).points, result.points)
    assert result.to_cloud(add="label").names == ["x", "y", "z", "deburr_label"]


def test_whatever_denoise_takes_can_be_written(tmp_path):
    deburr.write(tmp_path / "a.ply", POINTS)
    assert np.array_equal(deburr.read(tmp_path / "a.ply").points, POINTS)
    given = LegacyCloud()
    given.points, given.colors = Vectors(POINTS), Vectors(POINTS)
    deburr.write(tmp_path / "b.ply", given)
    again = deburr.read(tmp_path / "b.ply")
    assert np.array_equal(again["green"], POINTS[:, 1])
    assert deburr.write(tmp_path / "c.ply", given.points) == []

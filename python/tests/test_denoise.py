# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import dataclasses
import json
import pickle

import numpy as np
import pytest

import deburr


def test_noise_goes_and_edges_stay(scan, result):
    before, after = deburr.compare(scan.cloud, scan), deburr.compare(result, scan)
    inliers = ~scan.outliers
    noisy = deburr.metrics.compare_to_surface(scan.cloud.points[inliers], scan.truth).mean
    clean = deburr.metrics.compare_to_surface(result.points[inliers], scan.truth).mean
    assert clean < 0.5 * noisy
    assert after.edge_zone.mean < before.edge_zone.mean
    assert after.outliers.recall > 0.8


def test_result_tells_all_of_every_point(scan, result):
    n = len(scan.cloud)
    assert len(result) == n
    assert result.points.shape == result.normals.shape == (n, 3)
    for array, dtype in [
        (result.points, np.float64),
        (result.normals, np.float64),
        (result.labels, np.uint8),
        (result.outliers, np.bool_),
        (result.displacement, np.float64),
    ]:
        assert array.dtype == dtype
        assert len(array) == n
    moved = np.linalg.norm(result.points - scan.cloud.points, axis=1)
    np.testing.assert_allclose(moved, result.displacement, atol=1e-9)
    assert result.max_displacement <= result.report.max_move
    assert result.kept is None
    assert set(result.labels) <= set(map(int, deburr.Feature))


def test_result_cannot_be_changed(result):
    with pytest.raises(dataclasses.FrozenInstanceError):
        result.points = None
    with pytest.raises(dataclasses.FrozenInstanceError):
        result.report.noise = 0


def test_report_counts_what_the_arrays_hold(scan, result):
    report = result.report
    assert report.points == report.kept == len(scan.cloud)
    assert report.outliers == result.outliers.sum() > 0
    counts = {kind.name.lower(): int((result.labels == kind).sum()) for kind in deburr.Feature}
    assert report.labels == counts
    assert report.stages
    assert sum(stage.seconds for stage in report.stages) > 0
    assert json.loads(json.dumps(report.to_dict()))["noise"] == report.noise


def test_same_bits_for_any_threads(scan, result):
    for threads in (1, 3):
        again = deburr.denoise(scan.cloud.points, threads=threads)
        assert np.array_equal(again.points, result.points)
        assert np.array_equal(again.normals, result.normals)


def test_input_is_not_changed(scan, result):
    again = deburr.synth("part", points=2500, outliers=0.02, seed=3)
    assert np.array_equal(scan.cloud.points, again.cloud.points)
    assert not np.shares_memory(scan.cloud.points, result.points)


def test_removed_outliers_are_in_no_array(scan, result):
    removed = deburr.denoise(scan.cloud, outliers="remove")
    assert removed.report.kept == len(removed) == len(scan.cloud) - result.report.outliers
    assert removed.kept is not None
    assert np.array_equal(removed.kept, np.flatnonzero(~result.outliers))
    assert np.array_equal(removed.points, result.points[~result.outliers])
    assert not removed.outliers.any()


def test_outliers_kept_are_points_like_others(scan):
    assert deburr.denoise(scan.cloud, outliers="keep").report.outliers == 0


def test_strength_noise_and_max_move_have_their_effect(scan, result):
    weak = deburr.denoise(scan.cloud, strength=1)
    assert weak.report.noise < 0.6 * result.report.noise
    assert deburr.denoise(scan.cloud, noise=0.25).report.noise == pytest.approx(0.25)
    assert deburr.denoise(scan.cloud, max_move=0.125).max_displacement <= 0.125


def test_normals_kept_given_or_estimated(scan):
    cloud = deburr.PointCloud(scan.cloud.points, scan.normals)
    assert deburr.denoise(cloud).report.kept_normals
    assert not deburr.denoise(cloud, normals="estimate").report.kept_normals
    given = deburr.denoise(scan.cloud.points, normals=scan.normals.astype(np.float32))
    assert given.report.kept_normals
    with pytest.raises(deburr.DataError, match="normals are to be kept, but the points have none"):
        deburr.denoise(scan.cloud, normals="keep")


def test_published_method(scan):
    result = deburr.denoise(scan.cloud, method="yadav2018", rounds=2, update="simultaneous")
    assert len(result.report.rounds) == 2
    assert result.report.to_dict()["rounds"][1]["max_move"] == result.report.rounds[1].max_move
    assert result.report.rounds[0].max_move >= result.report.rounds[0].rms_move > 0


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"strength": 6}, "automatic.strength must be in [1, 5], got 6"),
        ({"noise": -1}, "automatic.noise must be finite and >= 0, got -1"),
        ({"max_move": float("nan")}, "automatic.max_move must be finite and >= 0, got nan"),
        ({"method": "fast"}, "method must be auto or yadav2018, got 'fast'"),
        ({"outliers": "drop"}, "outliers must be label, remove or keep, got 'drop'"),
        ({"normals": "mine"}, "normals must be auto, keep or estimate, got 'mine'"),
        ({"threads": -1}, "threads must be in [0, 256], got -1"),
        ({"rounds": 3}, "rounds belongs to method 'yadav2018'"),
        ({"method": "yadav2018", "strength": 2}, "strength belongs to method 'auto'"),
        ({"method": "yadav2018", "k": -1}, "k must be >= 0, got -1"),
        ({"method": "yadav2018", "rho": 1}, "yadav2018.rho must be in [0, 1), got 1"),
        ({"normals": np.zeros((2, 3))}, "normals must have one entry per point"),
    ],
)
def test_options_out_of_range(scan, options, words):
    with pytest.raises(ValueError) as caught:
        deburr.denoise(scan.cloud.points[:50], **options)
    assert words in str(caught.value)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"strength": 2.5}, "strength must be an integer, got 2.5"),
        ({"noise": "much"}, "noise must be a number, got 'much'"),
        ({"method": 3}, "method must be a word, got 3"),
    ],
)
def test_options_of_another_type(scan, options, words):
    with pytest.raises(TypeError) as caught:
        deburr.denoise(scan.cloud.points[:50], **options)
    assert str(caught.value) == words


def test_few_points_and_none_come_back():
    few = np.arange(9.0).reshape(3, 3)
    assert np.array_equal(deburr.denoise(few).points, few)
    nothing = deburr.denoise(np.empty((0, 3)))
    assert nothing.points.shape == (0, 3)
    assert len(deburr.denoise([])) == 0


def test_points_that_are_not_finite_stay(scan):
    points = scan.cloud.points[:500].copy()
    points[7] = np.nan
    result = deburr.denoise(points)
    assert result.report.non_finite == 1
    assert np.isnan(result.points[7]).all()
    assert result.labels[7] == deburr.Feature.ISOLATED


def test_pickle(result):
    again = pickle.loads(pickle.dumps(result))
    assert np.array_equal(again.points, result.points)
    assert again.report == result.report
    assert again.to_cloud().equals(result.to_cloud())


def test_repr_says_something(result):
    assert f"Result({len(result)} points, noise {result.report.noise:.6g}" in repr(result)
    html = result._repr_html_()
    assert "<table>" in html
    assert f"<td>{result.report.spacing:.6g}</td>" in html

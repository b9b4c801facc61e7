# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import pickle

import numpy as np
import pytest

import deburr


@pytest.fixture(scope="module")
def cube():
    return deburr.synth("cube", points=2000, noise=0)


@pytest.fixture(scope="module")
def near(cube):
    return deburr.find_neighbors(cube.cloud.points, max_count=12)


def test_neighbors_are_those_of_brute_force(cube):
    points = cube.cloud.points[:200]
    near = deburr.find_neighbors(points, max_count=5)
    distances = np.linalg.norm(points[:, np.newaxis] - points, axis=2)
    np.fill_diagonal(distances, np.inf)
    for i in (0, 17, 199):
        assert near[i].tolist() == np.argsort(distances[i], kind="stable")[:5].tolist()
    assert np.array_equal(near[-1], near[199])
    within = deburr.find_neighbors(points, radius=0.2)
    assert within.pair_count == (distances <= 0.2).sum()
    nearest = np.sort(distances, axis=1)[:, :5].mean()
    assert deburr.mean_neighbor_distance(points, near) == pytest.approx(nearest)


def test_neighborhoods_are_a_sparse_matrix(near):
    again = deburr.Neighborhoods(near.offsets, near.indices)
    assert len(again) == len(near) == 2000
    assert again.pair_count == near.pair_count == len(near.indices)
    assert np.array_equal(again[1999], near[1999])
    copy = pickle.loads(pickle.dumps(near))
    assert np.array_equal(copy.indices, near.indices)
    assert repr(near) == "Neighborhoods(2000 points, 24000 pairs)"
    with pytest.raises(IndexError):
        near[2000]
    with pytest.raises(ValueError, match="offsets"):
        deburr.Neighborhoods(near.offsets + 1, near.indices)


def test_neighbors_need_a_limit(cube):
    with pytest.raises(ValueError, match=r"max_count|radius"):
        deburr.find_neighbors(cube.cloud.points)
    with pytest.raises(ValueError, match="max_count must be >= 0, got -3"):
        deburr.find_neighbors(cube.cloud.points, max_count=-3)


def test_normals(cube, near):
    points = cube.cloud.points
    normals = deburr.estimate_normals(points, near)
    oriented = deburr.orient_normals(points, normals, near)
    around = cube.normals[near.indices.reshape(-1, 12)]
    inner = (around == cube.normals[:, np.newaxis]).all(axis=(1, 2))  # on one face
    assert inner.sum() > 500
    along = np.abs((oriented * cube.normals).sum(axis=1))
    np.testing.assert_allclose(along[inner], 1, atol=1e-6)
    np.testing.assert_array_equal(np.abs(oriented), np.abs(normals))
    refit = deburr.refit_normals(points, cube.normals, near, position_scale=0.1)
    np.testing.assert_allclose(np.linalg.norm(refit, axis=1), 1)
    filtered = deburr.filter_normals(cube.normals, near)
    np.testing.assert_allclose(filtered, cube.normals, atol=1e-9)
    silent = deburr.filter_normals(cube.normals, deburr.find_neighbors(points, radius=1e-9))
    np.testing.assert_array_equal(silent, cube.normals)
    silent = deburr.filter_normals(
        cube.normals, deburr.find_neighbors(points, radius=1e-9), voteless="zero"
    )
    assert not silent.any()


def test_features_and_positions(cube):
    points = cube.cloud.points
    near = deburr.find_neighbors(points, radius=0.12)
    # Smooth enough that normals vary over an edge, which is what tells it.
    normals = deburr.estimate_normals(points, near)
    normals = deburr.orient_normals(points, normals, near)
    field = deburr.classify_features(points, normals, near, rho=0.2)
    assert field.label.dtype == np.uint8
    assert field.direction.shape == points.shape
    edges = field.label == deburr.Feature.EDGE
    assert np.array_equal(np.linalg.norm(field.direction, axis=1) > 0.5, edges)
    noisy = points + np.random.default_rng(5).normal(0, 0.01, points.shape)
    moved = deburr.update_positions(
        noisy, noisy, cube.normals, field, near, position_scale=0.1, max_move=0.03
    )
    assert np.linalg.norm(moved - noisy, axis=1).max() <= 0.03 + 1e-12
    error = [deburr.metrics.compare_to_surface(p, cube.truth).mean for p in (noisy, moved)]
    assert error[1] < 0.8 * error[0]
    update = {"position_scale": 0.1, "max_move": 0.03}
    swept, classes = deburr.sweep_at_once(noisy, noisy, cube.normals, near, rho=0.2, **update)
    expected = deburr.classify_features(noisy, cube.normals, near, rho=0.2)
    assert np.array_equal(classes.label, expected.label)
    both = deburr.update_positions(noisy, noisy, cube.normals, expected, near, **update)
    assert np.array_equal(swept, both)
    one, _ = deburr.sweep_in_place(noisy, noisy, cube.normals, near, order=[5], **update)
    assert np.flatnonzero((one != noisy).any(axis=1)).tolist() == [5]
    every, _ = deburr.sweep_in_place(noisy, noisy, cube.normals, near, **update)
    assert (every != noisy).any(axis=1).sum() > 1900
    with pytest.raises(ValueError, match="offset must be projected or symmetric, got 'x'"):
        deburr.update_positions(
            noisy,
            noisy,
            normals,
            field,
            near,
            position_scale=1,
            offset="x",  # type: ignore
        )
    with pytest.raises(ValueError, match="position_scale"):
        deburr.update_positions(noisy, noisy, normals, field, near, position_scale=0)


def test_noise(cube):
    noisy = deburr.synth("cube", points=3000, noise=0.01)
    estimate = deburr.measure_noise(noisy.cloud.points)
    assert estimate.sigma == pytest.approx(noisy.sigma, rel=0.15)
    assert deburr.estimate_noise(noisy.cloud.points) == estimate.sigma
    local = deburr.estimate_local_noise(noisy.cloud.points)
    assert local.overall == estimate
    assert local.sigma.shape == local.spacing.shape == (3000,)
    assert deburr.measure_noise(cube.cloud.points[:5]).sigma == 0


def test_outliers(scan):
    flags = deburr.find_outliers(scan.cloud.points)
    assert flags.dtype == np.bool_
    score = deburr.metrics.score_outliers(flags, scan.outliers)
    assert score.recall > 0.8
    loose = deburr.find_outliers(scan.cloud.points, tolerance=3)
    assert loose.sum() < flags.sum()
    with pytest.raises(ValueError, match="tolerance"):
        deburr.find_outliers(scan.cloud.points, tolerance=0)

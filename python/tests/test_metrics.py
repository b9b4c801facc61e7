# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import json
import subprocess

import numpy as np
import pytest

import deburr


def test_compare_gives_what_the_program_gives(tmp_path, program, scan, result):
    cloud, truth, clean = (tmp_path / name for name in ("cloud.ply", "truth.ply", "clean.ply"))
    deburr.write(cloud, result)
    deburr.write_mesh(truth, scan.truth)
    fields = {"outlier": scan.outliers.astype(np.uint8)}
    deburr.write(clean, deburr.PointCloud(scan.clean, scan.normals, fields))
    command = [program, "compare", cloud, "--truth", truth, "--clean", clean, "--json"]
    told = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
    figures = deburr.compare(result, scan)

    def numbers(part):
        if isinstance(part, dict):
            return [x for value in part.values() for x in numbers(value)]
        if isinstance(part, list):
            return [x for value in part for x in numbers(value)]
        return [part] if isinstance(part, float) else []

    programs = numbers(told)
    ours = [
        figures.error.mean,
        figures.error.rms,
        figures.error.percentile_95,
        figures.coverage.mean,
        figures.normals.oriented,
        figures.edge_zone.mean,
        figures.features.edge_precision,
        figures.features.edge_recall,
        figures.outliers.recall,
        figures.offsets.rms,
        figures.offsets.far_share,
    ]
    for number in ours:
        assert any(number == pytest.approx(other, rel=1e-12) for other in programs), number


def test_compare_with_a_cloud(scan):
    figures = deburr.compare(scan.cloud, scan.clean)
    brute = np.linalg.norm(scan.cloud.points[:50, np.newaxis] - scan.clean, axis=2).min(axis=1)
    found = deburr.metrics.distance_to_cloud(scan.cloud.points[:50], scan.clean)
    np.testing.assert_allclose(found, brute)
    assert figures.chamfer > 0
    assert figures.spacing is None
    assert figures.normals is None
    truth = deburr.PointCloud(scan.clean, scan.normals)
    with_normals = deburr.compare(deburr.PointCloud(scan.cloud.points, scan.normals), truth)
    assert with_normals.normals.oriented < 10


def test_normals_are_compared_with_normals(scan):
    with pytest.raises(ValueError, match="truth must have normals, got none"):
        deburr.metrics.normal_error(scan.clean, scan.normals, deburr.PointCloud(scan.clean))


def test_an_outlier_has_no_place_without_noise(scan):
    fields = {"outlier": scan.outliers}
    clean = deburr.PointCloud(scan.clean, np.ones_like(scan.clean), fields)
    figures = deburr.compare(scan.cloud, scan.truth, clean=clean)
    assert figures.offsets.count == (~scan.outliers).sum()


def test_distance_to_a_surface():
    square = deburr.TriangleMesh(
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]]
    )
    points = [[0.5, 0.25, 2], [3, 1, 0], [np.nan, 0, 0]]
    np.testing.assert_allclose(deburr.metrics.distance_to_surface(points, square), [2, 2, np.nan])
    error = deburr.metrics.compare_to_surface(points, square)
    assert (error.mean, error.count) == (2, 2)
    assert deburr.metrics.mean_spacing(square, 4) == 0.5
    up = deburr.metrics.normal_error(points[:2], [[0, 0, 1], [0, 0, -1]], square)
    assert (up.unoriented, up.oriented) == (0, 90)
    assert len(deburr.metrics.find_sharp_features(square).edges) == 0


def test_sharp_features_of_a_cube():
    sharp = deburr.metrics.find_sharp_features(deburr.shape_mesh("cube"))
    assert sharp.edges.shape == (12, 2, 3)
    assert sharp.corners.shape == (8, 3)


def test_clean_must_be_the_same_points(scan):
    with pytest.raises(ValueError, match="clean must have one entry per point"):
        deburr.compare(scan.cloud, scan.truth, clean=deburr.PointCloud(scan.clean[:5]))


def test_nothing_finite():
    figures = deburr.compare(np.full((4, 3), np.nan), deburr.shape_mesh("cube"))
    assert figures.error.count == 0
    assert figures.coverage is None
    assert "<table>" in figures._repr_html_()


@pytest.mark.parametrize(
    ("vertices", "triangles", "words"),
    [
        (np.zeros((3, 2)), [[0, 1, 2]], "vertices must have shape (N, 3)"),
        (np.zeros((3, 3)), [[0, 1, 3]], "triangles must be indices of 3 vertices"),
        (np.zeros((3, 3)), [[0, 1, -1]], "triangles must be indices of 3 vertices"),
        (np.zeros((3, 3)), [[0.0, 1, 2]], "triangles must be integers"),
        (np.zeros((3, 3)), [0, 1, 2], "triangles must be integers of shape (T, 3)"),
    ],
)
def test_meshes_that_are_none(vertices, triangles, words):
    with pytest.raises(ValueError) as caught:
        deburr.TriangleMesh(vertices, triangles)
    assert words in str(caught.value)


def test_synth_is_that_of_the_program(tmp_path, program):
    path = tmp_path / "torus.ply"
    command = [program, "synth", "torus", path, "--points", "500", "--seed", "9"]
    subprocess.run([*command, "--quiet"], check=True)
    scan = deburr.synth("torus", points=500, seed=9)
    assert np.array_equal(deburr.read(path).points, scan.cloud.points)
    of_mesh = deburr.synth(scan.truth, points=100)
    assert len(of_mesh.cloud) == 100
    assert "500 points, 0 outliers" in repr(scan)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"shape": "egg"}, "shape must be part, cube"),
        ({"points": 0}, "points"),
        ({"seed": -1}, "seed must be in [0, 2^64 - 1], got -1"),
        ({"noise": -0.1}, "noise"),
        ({"sampling": "dense"}, "sampling must be uniform, poisson or scanner, got 'dense'"),
    ],
)
def test_synth_out_of_range(options, words):
    with pytest.raises(ValueError) as caught:
        deburr.synth(**{"points": 10, **options})
    assert words in str(caught.value)

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Clouds of other libraries: stand-ins that have what theirs have, and theirs where installed."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from stand_ins import LegacyCloud, Mesh, Tensor, TensorCloud, Vectors

import deburr


@pytest.fixture(params=["label", "remove"])
def outliers(request):
    return request.param


@pytest.fixture(scope="module")
def points(scan):
    return scan.cloud.points[:1500]


@pytest.fixture(scope="module")
def number(points):
    return np.arange(len(points))


def kept(result, number):
    return number if result.kept is None else number[result.kept.astype(int)]


def test_open3d_legacy(points, number, outliers):
    given = LegacyCloud()
    given.points, given.colors = Vectors(points), Vectors(np.stack([number] * 3, axis=1))
    result = deburr.denoise(given, outliers=outliers)
    clean = result.as_given()
    assert isinstance(clean, LegacyCloud)
    assert np.array_equal(clean.points.array, result.points)
    assert np.array_equal(clean.normals.array, result.normals)
    assert np.array_equal(clean.colors.array[:, 0], kept(result, number))
    assert np.array_equal(given.points.array, points)
    assert (len(result) < len(points)) == (outliers == "remove")
    assert deburr.denoise(clean).report.kept_normals


def test_open3d_tensor(points, number, outliers):
    attributes = {"positions": Tensor(points.astype(np.float32)), "id": Tensor(number[:, None])}
    given = TensorCloud(dict(attributes))
    result = deburr.denoise(given, outliers=outliers)
    clean = result.as_given()
    assert isinstance(clean, TensorCloud)
    assert clean.point["positions"].array.dtype == np.float32
    assert np.array_equal(clean.point["positions"].array, result.points)
    assert np.array_equal(clean.point["id"].array[:, 0], kept(result, number))
    assert np.array_equal(clean.point["deburr_label"].array[:, 0], result.labels)
    assert {tensor.device for tensor in clean.point.values()} == {"CUDA:0"}
    assert given.point == attributes
    assert deburr.denoise(clean).report.kept_normals


def test_pyvista(points, number, outliers):
    given = Mesh(points.astype(np.float32))
    given.point_data["id"] = number
    result = deburr.denoise(given, outliers=outliers)
    clean = result.as_given()
    assert isinstance(clean, Mesh)
    assert np.array_equal(clean.points, result.points)
    assert np.array_equal(clean.point_data["id"], kept(result, number))
    assert np.array_equal(clean.point_data["deburr_label"], result.labels)
    assert "deburr_label" not in given.point_data
    assert deburr.denoise(clean).report.kept_normals


def test_nothing_is_imported():
    code = (
        "import sys, deburr; deburr.denoise(deburr.synth('cube', points=100).cloud.points);"
        "print(*{'open3d', 'laspy', 'pyvista', 'pandas', 'pye57', 'lazrs'} & {*sys.modules})"
    )
    run = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert run.stdout == "\n"


def test_real_open3d(points, number, outliers):
    o3d = pytest.importorskip("open3d", reason="NO OPEN3D")
    legacy = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    legacy.colors = o3d.utility.Vector3dVector(np.stack([number / len(number)] * 3, axis=1))
    result = deburr.denoise(legacy, outliers=outliers)
    clean = result.as_given()
    assert isinstance(clean, o3d.geometry.PointCloud)
    assert np.array_equal(np.asarray(clean.points), result.points)
    assert np.array_equal(np.asarray(clean.colors)[:, 0], kept(result, number) / len(number))
    tensor = o3d.t.geometry.PointCloud.from_legacy(legacy, o3d.core.float64)
    tensor.point["id"] = o3d.core.Tensor(number[:, None])
    result = deburr.denoise(tensor, outliers=outliers)
    clean = result.as_given()
    assert isinstance(clean, o3d.t.geometry.PointCloud)
    assert np.array_equal(clean.point["positions"].numpy(), result.points)
    assert np.array_equal(clean.point["id"].numpy()[:, 0], kept(result, number))
    assert np.array_equal(clean.point["deburr_label"].numpy()[:, 0], result.labels)


def test_real_pyvista(points, number, outliers):
    pv = pytest.importorskip("pyvista", reason="NO PYVISTA")
    given = pv.PolyData(points)
    given.point_data["id"] = number
    result = deburr.denoise(given, outliers=outliers)
    clean = result.as_given()
    assert isinstance(clean, pv.PolyData)
    assert np.array_equal(np.asarray(clean.points), result.points)
    assert np.array_equal(np.asarray(clean.point_data["id"]), kept(result, number))
    assert np.array_equal(np.asarray(clean.point_data["deburr_label"]), result.labels)

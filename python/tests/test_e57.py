# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import numpy as np
import pytest

import deburr

pye57 = pytest.importorskip("pye57", reason="NO PYE57: pip install deburr[e57]")
libe57 = pye57.libe57

CRS = 'PROJCS["a town"]'
POSES = [
    ([np.cos(0.3), 0, 0, np.sin(0.3)], [10.0, -5.0, 2.0]),
    ([1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0]),
]


def fields_of(points, seed):
    rng = np.random.default_rng(seed)
    n = len(points)
    return {
        **dict(zip(("cartesianX", "cartesianY", "cartesianZ"), points.T.copy(), strict=True)),
        "intensity": rng.random(n, dtype=np.float32),
        "colorRed": rng.integers(0, 256, n, dtype=np.uint8),
        "colorGreen": rng.integers(0, 256, n, dtype=np.uint8),
        "colorBlue": rng.integers(0, 256, n, dtype=np.uint8),
        "rowIndex": rng.integers(0, 3000, n, dtype=np.uint16),
        "columnIndex": rng.integers(0, 3000, n, dtype=np.uint16),
        "cartesianInvalidState": np.zeros(n, np.int8),
    }


@pytest.fixture
def path(tmp_path, scan):
    """Two scans at different places, written by pye57."""
    path = tmp_path / "two.e57"
    file = pye57.E57(str(path), mode="w")
    for number, (rotation, translation) in enumerate(POSES):
        points = scan.cloud.points[number::2][:900]
        fields = fields_of(points, number)
        fields["cartesianInvalidState"][5] = 2
        file.write_scan_raw(
            fields,
            name=f"station {number}",
            rotation=np.array(rotation),
            translation=np.array(translation),
        )
    file.close()
    return path


def raw_scans(path):
    file = pye57.E57(str(path))
    scans = [file.read_scan_raw(i, ignore_unsupported_fields=True) for i in range(file.scan_count)]
    headers = [file.get_header(i) for i in range(file.scan_count)]
    told = [
        (h["name"].value(), h["guid"].value(), h.rotation.tolist(), h.translation.tolist())
        for h in headers
    ]
    file.close()
    return scans, told


def test_scans_are_one_cloud_in_the_coordinates_of_the_file(path):
    cloud = deburr.read(path)
    assert len(cloud) == 1800
    assert cloud["scan"].tolist() == [0] * 900 + [1] * 900
    reference = pye57.E57(str(path))
    invalid = cloud["cartesianInvalidState"] != 0
    assert np.isnan(cloud.points[invalid]).all()
    for number in (0, 1):
        expected = reference.read_scan(number, ignore_missing_fields=True)
        points = cloud.points[(cloud["scan"] == number) & ~invalid]
        for axis, name in enumerate(("cartesianX", "cartesianY", "cartesianZ")):
            np.testing.assert_allclose(points[:, axis], expected[name], atol=1e-12)
    reference.close()
    assert cloud["red"].dtype == np.uint8
    assert cloud["intensity"].dtype == np.float32


def test_through_denoise_and_back(path, tmp_path):
    copy = tmp_path / "clean.e57"
    cloud = deburr.read(path)
    result = deburr.denoise(cloud)
    assert result.report.non_finite == 2
    assert deburr.write(copy, result) == []
    before, told_before = raw_scans(path)
    after, told_after = raw_scans(copy)
    assert told_after == told_before
    for first, second in zip(before, after, strict=True):
        for name in first:
            if name.startswith("cartesian") and name != "cartesianInvalidState":
                continue
            assert first[name].dtype == second[name].dtype
            assert np.array_equal(first[name], second[name]), name
    again = deburr.read(copy)
    np.testing.assert_allclose(again.points, result.points, rtol=0, atol=1e-12)
    np.testing.assert_allclose(again.normals, result.normals, rtol=0, atol=1e-12)
    assert np.array_equal(again["deburr_label"], result.labels)
    for name in cloud.fields:
        assert again[name].dtype == cloud[name].dtype
        assert np.array_equal(again[name], cloud[name]), name


def test_removed_points_are_in_no_scan(path, tmp_path):
    result = deburr.denoise(deburr.read(path), outliers="remove")
    deburr.write(tmp_path / "fewer.e57", result)
    again = deburr.read(tmp_path / "fewer.e57")
    assert len(again) == len(result) < 1800


def make_full(path, points):
    """What pye57 does not write: a coordinate system, scaled integers, times, images."""
    file = libe57.ImageFile(str(path), "w")
    file.extensionsAdd("", libe57.E57_V1_0_URI)
    file.extensionsAdd("own", "urn:own")
    root = file.root()
    root.set("formatName", libe57.StringNode(file, "ASTM E57 3D Imaging Data File"))
    root.set("guid", libe57.StringNode(file, "{the file}"))
    root.set("versionMajor", libe57.IntegerNode(file, 1))
    root.set("versionMinor", libe57.IntegerNode(file, 0))
    root.set("coordinateMetadata", libe57.StringNode(file, CRS))
    images = libe57.VectorNode(file, True)
    root.set("images2D", images)
    image = libe57.StructureNode(file)
    images.append(image)
    blob = libe57.BlobNode(file, 5)
    image.set("jpegImage", blob)
    blob.write(bytearray(b"\1\2\3\4\5"), 0, 5)
    scans = libe57.VectorNode(file, True)
    root.set("data3D", scans)
    node = libe57.StructureNode(file)
    scans.append(node)
    node.set("guid", libe57.StringNode(file, "{the scan}"))
    node.set("sensorVendor", libe57.StringNode(file, "a vendor"))
    node.set("temperature", libe57.FloatNode(file, 21.5))
    shape = libe57.StructureNode(file)
    n = len(points)
    columns = {name: points[:, i].copy() for i, name in enumerate("XYZ")}
    for name in columns:
        shape.set("cartesian" + name, libe57.ScaledIntegerNode(file, 0, -(2**40), 2**40, 1e-4, 0.0))
    columns = {"cartesian" + name: array for name, array in columns.items()}
    columns["timeStamp"] = np.linspace(0, 1, n) + 1e9
    shape.set("timeStamp", libe57.FloatNode(file, 0.0, libe57.FloatPrecision.E57_DOUBLE, 0.0, 2e9))
    columns["intensity"] = np.arange(n) % 1000 * 0.5
    shape.set("intensity", libe57.ScaledIntegerNode(file, 0, 0, 2047, 0.5, 0.0))
    columns["own:count"] = (np.arange(n) - 40).astype(np.int32)
    shape.set("own:count", libe57.IntegerNode(file, 0, -40, 70000))
    buffers, arrays = libe57.VectorSourceDestBuffer(), []
    for name, array in columns.items():
        held = array.astype("q") if array.dtype == np.int32 else array
        columns[name] = held.astype(array.dtype)
        arrays.append(held)
        buffers.append(libe57.SourceDestBuffer(file, name, held, n, True, True))
    vector = libe57.CompressedVectorNode(file, shape, libe57.VectorNode(file, True))
    node.set("points", vector)
    writer = vector.writer(buffers)
    writer.write(n)
    writer.close()
    file.close()
    return columns


def test_everything_of_the_header_survives(tmp_path, scan):
    first, second = tmp_path / "first.e57", tmp_path / "second.e57"
    columns = make_full(first, scan.cloud.points[:800])
    cloud = deburr.read(first)
    np.testing.assert_allclose(cloud.points, scan.cloud.points[:800], atol=6e-5)
    for name in ("timeStamp", "intensity", "own:count"):
        assert np.array_equal(cloud[name], columns[name])
    result = deburr.denoise(cloud)
    deburr.write(second, result)
    again = deburr.read(second)
    np.testing.assert_array_equal(again.points, result.points)
    for name in ("timeStamp", "intensity", "own:count"):
        assert again[name].dtype == cloud[name].dtype
        assert np.array_equal(again[name], columns[name])
    file = libe57.ImageFile(str(second), "r")
    root = file.root()
    assert root["coordinateMetadata"].value() == CRS
    assert root["guid"].value() == "{the file}"
    image = bytearray(5)
    root["images2D"][0]["jpegImage"].read(image, 0, 5)
    assert image == b"\1\2\3\4\5"
    node = root["data3D"][0]
    assert node["sensorVendor"].value() == "a vendor"
    assert node["temperature"].value() == 21.5
    prototype = libe57.StructureNode(node["points"].prototype())
    assert prototype["intensity"].scale() == 0.5
    assert node["cartesianBounds"]["xMaximum"].value() == result.points[:, 0].max()
    file.close()


def test_a_cloud_from_elsewhere(tmp_path):
    path = tmp_path / "new.e57"
    fields = {
        "red": np.array([1, 2], np.uint8),
        "my field": np.array([0.5, np.nan]),
        "name": ["a", "b"],
    }
    cloud = deburr.PointCloud([[0, 0, 0], [1, 2, 3]], fields=fields)
    cloud.layout.comments.append("a comment")
    with pytest.warns(deburr.FormatWarning):
        losses = deburr.write(path, cloud)
    assert losses == [
        "E57 cannot hold comments, 1 left out",
        "E57 cannot hold the text 'name', which were left out",
    ]
    again = deburr.read(path)
    assert again.names == ["x", "y", "z", "red", "my_field"]
    np.testing.assert_array_equal(again["my_field"], [0.5, np.nan])
    with pytest.raises(deburr.DataError, match="E57 needs a point that is finite"):
        deburr.write(path, deburr.PointCloud(np.full((2, 3), np.nan)))


def test_spherical_coordinates(tmp_path):
    path = tmp_path / "spherical.e57"
    file = libe57.ImageFile(str(path), "w")
    file.extensionsAdd("", libe57.E57_V1_0_URI)
    scans = libe57.VectorNode(file, True)
    file.root().set("data3D", scans)
    node = libe57.StructureNode(file)
    scans.append(node)
    shape, buffers = libe57.StructureNode(file), libe57.VectorSourceDestBuffer()
    columns = {
        "sphericalRange": np.array([2.0, 2.0]),
        "sphericalAzimuth": np.array([0.0, np.pi / 2]),
        "sphericalElevation": np.array([0.0, np.pi / 6]),
    }
    for name, array in columns.items():
        shape.set(name, libe57.FloatNode(file))
        buffers.append(libe57.SourceDestBuffer(file, name, array, 2, True, True))
    vector = libe57.CompressedVectorNode(file, shape, libe57.VectorNode(file, True))
    node.set("points", vector)
    writer = vector.writer(buffers)
    writer.write(2)
    writer.close()
    file.close()
    cloud = deburr.read(path)
    np.testing.assert_allclose(cloud.points, [[2, 0, 0], [0, 3**0.5, 1]], atol=1e-15)
    deburr.write(path, cloud)
    np.testing.assert_array_equal(deburr.read(path).points, cloud.points)


def test_damaged_files_are_refused(path):
    path.write_bytes(path.read_bytes()[:2000])
    with pytest.raises(deburr.DeburrIOError, match=r"two\.e57"):
        deburr.read(path)

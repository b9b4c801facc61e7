# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import struct

import numpy as np
import pytest

laspy = pytest.importorskip("laspy", reason="NO LASPY: pip install deburr[las]")
pytest.importorskip("lazrs", reason="NO LAZRS: pip install deburr[las]")
from las_files import WKT, make_las, records  # noqa: E402
from laspy.copc import Bounds, CopcReader  # noqa: E402

import deburr  # noqa: E402
from deburr import _octree  # noqa: E402


@pytest.fixture(autouse=True)
def _small_nodes(monkeypatch):
    monkeypatch.setattr(_octree, "_CELLS_BITS", 3)
    monkeypatch.setattr(_octree, "LEAF", 50)


def write(path, cloud, lost=None):
    """Writes a cloud, and expects one sentence about what was lost, or none."""
    if lost is None:
        assert deburr.write(path, cloud) == []
    else:
        with pytest.warns(deburr.FormatWarning, match=lost):
            assert len(deburr.write(path, cloud)) == 1


def by_time(las):
    return np.argsort(np.array(las.gps_time), kind="stable")


@pytest.fixture
def written(tmp_path, scan):
    """A file as laspy makes it, and the same as COPC."""
    las = make_las("1.4", 7, scan.cloud.points)
    las.write(tmp_path / "in.laz")
    write(tmp_path / "out.copc.laz", deburr.read(tmp_path / "in.laz"))
    return las, tmp_path / "out.copc.laz"


def test_every_dimension_and_record_stays(written):
    las, path = written
    again = laspy.read(path)
    assert again.header.point_format.id == 7
    assert [*again.point_format.dimension_names] == [*las.point_format.dimension_names]
    for name in las.point_format.dimension_names:
        before, after = np.array(las[name])[by_time(las)], np.array(again[name])[by_time(again)]
        assert before.dtype == after.dtype
        assert np.array_equal(before, after), name
    assert np.array_equal(again.header.scales, las.header.scales)
    plain, extended = records(again)
    assert plain[0][:2] == ("copc", 1)
    # laspy tells the range of an extra dimension only when it writes.
    described = [r for r in records(las)[0] if r[:2] != ("LASF_Spec", 4)]
    assert [r for r in plain[1:] if r[:2] != ("LASF_Spec", 4)] == described
    assert extended[0][:2] == ("copc", 1000)
    assert extended[1:] == records(las)[1]
    assert list(again.header.number_of_points_by_return) == list(
        np.bincount(np.array(las.return_number), minlength=16)[1:]
    )


def test_layout_is_that_of_the_specification(written):
    las, path = written
    data = path.read_bytes()
    assert data[:4] == b"LASF"
    assert data[94:96] == struct.pack("<H", 375)
    assert data[377:381] == b"copc"
    assert data[393:397] == struct.pack("<HH", 1, 160)
    info = struct.unpack_from("<5d2Q2d11Q", data, 429)
    assert info[4] == pytest.approx(2 * info[3] / 8)
    assert info[7:9] == (las.gps_time.min(), las.gps_time.max())
    assert not any(info[9:])
    assert struct.unpack_from("<H", data, 6)[0] & 16
    page, size = info[5:7]
    assert struct.unpack_from("<H16sHQ", data, page - 60)[1:] == (
        b"copc".ljust(16, b"\0"),
        1000,
        size,
    )
    chunks = [struct.unpack_from("<4iQ2i", data, page + at) for at in range(0, size, 32)]
    assert len(chunks) > 20
    assert sum(chunk[-1] for chunk in chunks) == len(las)
    keys = {chunk[:4] for chunk in chunks}
    assert {(k - 1, x // 2, y // 2, z // 2) for k, x, y, z in keys if k > 0} <= keys
    ends = [chunk[4] + chunk[5] for chunk in chunks]
    assert [chunk[4] for chunk in chunks[1:]] == ends[:-1]


def test_queries_by_box_and_level(written):
    las, path = written
    points = np.stack([las.x, las.y, las.z], axis=1)
    with CopcReader.open(path) as reader:
        low, high = np.quantile(points, 0.2, axis=0), np.quantile(points, 0.7, axis=0)
        inside = np.sort(las.gps_time[((points >= low) & (points <= high)).all(axis=1)])
        assert 10 < len(inside) < len(las) / 2
        found = reader.query(bounds=Bounds(low, high))
        assert np.array_equal(np.sort(found.gps_time), inside)
        levels = [reader.query(level=level) for level in range(8)]
        times = np.concatenate([level.gps_time for level in levels])
        assert np.array_equal(np.sort(times), np.sort(las.gps_time))
        assert len(levels[0]) > 20
        assert len(levels[1]) > 0
        coarse = reader.query(resolution=reader.copc_info.spacing / 2)
        assert len(coarse) == len(levels[0]) + len(levels[1])


def test_points_lie_in_their_nodes(written):
    copclib = pytest.importorskip("copclib", reason="NO COPCLIB, another reader")
    las, path = written
    reader = copclib.FileReader(str(path))
    assert reader.ValidateSpatialBounds()
    assert len(reader.GetAllPoints()) == len(las)


def test_older_formats_become_newer_ones(tmp_path, scan):
    las = make_las("1.2", 3, scan.cloud.points)
    las.write(tmp_path / "in.las")
    write(tmp_path / "out.copc.laz", deburr.read(tmp_path / "in.las"))
    again = laspy.read(tmp_path / "out.copc.laz")
    assert (str(again.header.version), again.header.point_format.id) == ("1.4", 7)
    old, new = by_time(las), by_time(again)
    for name in las.point_format.dimension_names:
        if name == "scan_angle_rank":
            degrees = np.array(again["scan_angle"])[new] * 0.006
            assert np.allclose(degrees, np.array(las[name])[old], atol=0.003)
        else:
            assert np.array_equal(np.array(las[name])[old], np.array(again[name])[new]), name
    assert any(WKT.encode() in record[3] for record in records(again)[0])
    assert [r[:2] for r in records(again)[0]][1:] == [r[:2] for r in records(las)[0]]


@pytest.mark.parametrize("code", [25832, 32767], ids=["EPSG", "of its own"])
def test_geotiff_keys_become_wkt(tmp_path, scan, code):
    pytest.importorskip("pyproj", reason="NO PYPROJ, which knows coordinate systems")
    las = make_las("1.2", 1, scan.cloud.points[:300])
    keys = struct.pack("<16H", 1, 1, 0, 3, 1024, 0, 1, 1, 3072, 0, 1, code, 4096, 0, 1, 7837)
    las.vlrs[:] = [laspy.VLR("LASF_Projection", 34735, "keys", keys)]
    las.write(tmp_path / "in.las")
    lost = None if code == 25832 else "GeoTIFF keys"
    write(tmp_path / "out.copc.laz", deburr.read(tmp_path / "in.las"), lost)
    again = laspy.read(tmp_path / "out.copc.laz")
    assert any(r[1] == 34735 and r[3][:32] == keys for r in records(again)[0])
    system = again.header.parse_crs()
    if code == 25832:
        assert [part.to_epsg() for part in system.sub_crs_list] == [25832, 7837]


def test_waveforms_are_named_as_lost(tmp_path, scan):
    las = make_las("1.3", 4, scan.cloud.points[:200])
    las.write(tmp_path / "in.las")
    cloud = deburr.read(tmp_path / "in.las")
    write(tmp_path / "out.copc.laz", cloud, "waveforms")
    again = deburr.read(tmp_path / "out.copc.laz")
    order = np.argsort(again["gps_time"])
    old = np.argsort(cloud["gps_time"])
    assert {*cloud.names} - {"scan_angle_rank"} <= {*again.names}
    name = "wavepacket_size"
    assert np.array_equal(cloud[name][old], again[name][order])


def test_bytes_behind_a_header_are_named_as_lost(tmp_path, scan):
    las = make_las("1.4", 6, scan.cloud.points[:200])
    las.header.extra_header_bytes = b"what a scanner put there"
    las.write(tmp_path / "in.las")
    assert struct.unpack_from("<H", (tmp_path / "in.las").read_bytes(), 94)[0] > 375
    write(tmp_path / "out.copc.laz", deburr.read(tmp_path / "in.las"), "behind its header")
    with CopcReader.open(tmp_path / "out.copc.laz") as reader:
        assert len(reader.query()) == 200


def test_results_and_clouds_from_elsewhere(tmp_path, scan, result):
    number = np.arange(len(scan.cloud), dtype=np.uint32) + 70000
    fields = {"number": number, "red": np.full(len(number), 9, np.uint16)}
    cloud = deburr.PointCloud(
        scan.cloud.points, fields={**fields, **dict.fromkeys(("green", "blue"), fields["red"])}
    )
    cloud.layout.comments.append("made by hand")
    write(tmp_path / "a.copc.laz", deburr.denoise(cloud), "LAS rounds")
    again = deburr.read(tmp_path / "a.copc.laz")
    order = np.argsort(again["number"])
    assert np.array_equal(again["number"][order], number)
    assert np.array_equal(again["deburr_label"][order], result.labels)
    assert np.array_equal(again["classification"][order] == 7, result.outliers)
    np.testing.assert_allclose(again.points[order], result.points, atol=1e-6)
    np.testing.assert_allclose(again.normals[order], result.normals)
    assert again.layout.comments == ["made by hand"]
    las = laspy.read(tmp_path / "a.copc.laz")
    assert las.header.point_format.id == 7
    assert set(las.return_number) == set(las.number_of_returns) == {1}


@pytest.mark.parametrize("count", [0, 1, 300])
def test_few_points_and_points_at_one_place(tmp_path, count):
    cloud = deburr.PointCloud(np.full((count, 3), 2.5))
    write(tmp_path / "a.copc.laz", cloud)
    assert np.array_equal(deburr.read(tmp_path / "a.copc.laz").points, cloud.points)
    if count:
        with CopcReader.open(tmp_path / "a.copc.laz") as reader:
            assert len(reader.query()) == count


def test_copc_through_denoise_and_back(written, tmp_path):
    las, path = written
    cloud = deburr.read(path)
    write(path, cloud)
    assert [b.name for b in deburr.read(path).layout.blocks] == [
        b.name for b in cloud.layout.blocks
    ]
    again = laspy.read(path)
    assert [r[0] for some in records(again) for r in some].count("copc") == 2
    assert len(again) == len(las)
    deburr.write(tmp_path / "plain.laz", cloud)
    plain = records(laspy.read(tmp_path / "plain.laz"))
    assert not any(r[0] == "copc" for some in plain for r in some)


def test_laspy_objects_of_copc_files(written):
    las, path = written
    given = laspy.read(path)
    clean = deburr.denoise(given).as_given()
    assert len(clean) == len(las)
    assert np.array_equal(np.array(clean.gps_time), np.array(given.gps_time))
    assert [r[0] for some in records(given) for r in some].count("copc") == 2


def test_nodes_hold_every_point_once():
    points = np.random.default_rng(1).random((5000, 3)) * [10, 4, 1] + [1e6, 0, -5]
    cube = _octree.cube_around(points, 1e-3)
    nodes = _octree.nodes_of(points, cube, 200)
    assert np.array_equal(np.sort(np.concatenate([n.indices for n in nodes])), np.arange(5000))
    for node in nodes:
        edge = 2 * cube.half / 2**node.level
        low = cube.center - cube.half + edge * np.array([node.x, node.y, node.z])
        assert (points[node.indices] >= low - 1e-9).all()
        assert (points[node.indices] <= low + edge + 1e-9).all()
        if len(node.indices) > 200:
            cells = np.floor((points[node.indices] - low) / edge * 8 + 1e-9)
            assert len(np.unique(cells, axis=0)) >= len(cells) - 2
    assert [node.level for node in nodes] == sorted(node.level for node in nodes)

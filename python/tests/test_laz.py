# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import struct
import subprocess

import numpy as np
import pytest
from las_files import WKT, make_las, records

import deburr

laspy = pytest.importorskip("laspy", reason="NO LASPY: pip install deburr[las]")
lazrs = pytest.importorskip("lazrs", reason="NO LAZRS: pip install deburr[las]")


@pytest.fixture(params=[("1.2", 3), ("1.4", 7)], ids=["1.2", "1.4"])
def las(request, scan):
    return make_las(*request.param, scan.cloud.points[:1200])


def test_laz_is_read_as_las(tmp_path, las):
    las.write(tmp_path / "a.laz")
    las.write(tmp_path / "a.las")
    packed, plain = deburr.read(tmp_path / "a.laz"), deburr.read(tmp_path / "a.las")
    assert packed.equals(plain)
    assert "reflectance" in packed.names
    assert any(WKT.encode() in block.data for block in packed.layout.blocks)


def test_through_denoise_and_back(tmp_path, las):
    first, second = tmp_path / "first.laz", tmp_path / "second.laz"
    las.write(first)
    result = deburr.denoise(deburr.read(first))
    deburr.write(second, result)
    clean = laspy.read(second)
    assert second.stat().st_size < 1.5 * first.stat().st_size + 60 * len(result)
    assert clean.header.version == las.header.version
    assert clean.header.point_format.id == las.header.point_format.id
    assert [r for r in records(clean)[0] if r[1] != 4] == [r for r in records(las)[0] if r[1] != 4]
    assert records(clean)[1] == records(las)[1]
    for name in las.point_format.dimension_names:
        if name in ("X", "Y", "Z"):
            continue
        before, after = np.array(las[name]), np.array(clean[name])
        if name == "classification":
            assert (after[result.outliers] == 7).all()
            before, after = before[~result.outliers], after[~result.outliers]
        assert before.dtype == after.dtype
        assert np.array_equal(before, after), name
    moved = np.stack([clean.x, clean.y, clean.z], axis=1)
    np.testing.assert_allclose(moved, result.points, atol=0.6 * clean.header.scales.max())
    assert np.array_equal(np.array(clean["deburr_label"]), result.labels)
    still = result.displacement == 0
    assert np.array_equal(moved[still], np.stack([las.x, las.y, las.z], axis=1)[still])


def test_laz_and_las_are_written_alike(tmp_path, las):
    las.write(tmp_path / "in.laz")
    cloud = deburr.read(tmp_path / "in.laz")
    deburr.write(tmp_path / "out.laz", cloud)
    deburr.write(tmp_path / "out.las", cloud)
    assert deburr.read(tmp_path / "out.laz").equals(deburr.read(tmp_path / "out.las"))
    packed, plain = laspy.read(tmp_path / "out.laz"), laspy.read(tmp_path / "out.las")
    assert np.array_equal(packed.points.array, plain.points.array)
    assert (tmp_path / "out.laz").stat().st_size < (tmp_path / "out.las").stat().st_size
    assert [path.name for path in tmp_path.glob(".deburr*")] == []


def test_files_appear_whole_or_not_at_all(tmp_path, las):
    cloud = deburr.denoise(las).to_cloud()
    folder = tmp_path / "folder.laz"
    folder.mkdir()
    with pytest.raises(deburr.DeburrIOError, match=r"folder\.laz"):
        deburr.write(folder, cloud)
    assert [path.name for path in tmp_path.iterdir()] == ["folder.laz"]
    mine = tmp_path / "mine.laz"
    mine.touch(0o600)
    link = tmp_path / "link.laz"
    link.symlink_to(mine)
    deburr.write(link, cloud)
    assert link.is_symlink()
    assert mine.stat().st_mode & 0o777 == 0o600
    assert len(deburr.read(mine)) == len(cloud)


def test_a_coarse_grid_is_refined_as_by_the_program(tmp_path, program, scan):
    las = make_las("1.2", 3, scan.cloud.points[:1200])
    las.change_scaling(scales=[0.25] * 3)
    source, theirs, ours = (tmp_path / name for name in ("in.las", "theirs.las", "ours.las"))
    las.write(source)
    subprocess.run([program, "denoise", source, theirs, "--quiet"], check=True)
    deburr.write(ours, deburr.denoise(deburr.read(source)))
    assert ours.read_bytes() == theirs.read_bytes()
    assert laspy.read(ours).header.scales[0] < 0.25


def test_laspy_objects(las):
    before = np.array(las.points.array)
    result = deburr.denoise(las)
    clean = result.as_given()
    assert isinstance(clean, laspy.LasData)
    assert np.array_equal(las.points.array, before)
    assert np.array_equal(np.array(clean.gps_time), np.array(las.gps_time))
    np.testing.assert_allclose(clean.xyz, result.points, atol=0.6 * clean.header.scales.max())
    assert len(deburr.denoise(las, outliers="remove").as_given()) < len(las) or not (
        result.report.outliers
    )


def make_copc(path, las):
    """Packs points in pieces of any size, as COPC does, with its records."""
    las.write(path)
    data = path.read_bytes()
    head = 375
    records = b""
    info = struct.pack("<5d2Q2d11Q", *[0.0] * 5, 0, 0, 0.0, 0.0, *[0] * 11)
    records += struct.pack("<H16sHH32s", 0, b"copc", 1, len(info), b"COPC info VLR") + info
    scheme = lazrs.LazVlr.new_for_compression(7, 4, use_variable_size_chunks=True)
    packing = scheme.record_data()
    laszip = struct.pack("<H16sHH32s", 0, b"laszip encoded", 22204, len(packing), b"") + packing
    (count,) = struct.unpack_from("<I", data, 100)
    at, kept = head, b""
    for _ in range(count):
        number, length = struct.unpack_from("<18xHH", data, at)
        if number != 22204:
            kept += data[at : at + 54 + length]
        at += 54 + length
    header = bytearray(data[:head])
    body = records + kept + laszip
    struct.pack_into("<II", header, 96, head + len(body), count + 1)
    with path.open("w+b") as file:
        file.write(header + body)
        packer = lazrs.LasZipCompressor(file, scheme)
        raw = las.points.array.tobytes()
        size = las.points.point_size
        for begin, end in ((0, 500), (500, 501), (501, len(las))):
            packer.compress_many(raw[begin * size : end * size])
            packer.finish_current_chunk()
        packer.done()
        file.seek(0, 2)
        tail_at = file.tell()
        file.write(struct.pack("<H16sHQ32s", 0, b"copc", 1000, 32, b"") + bytes(32))
        struct.pack_into("<QI", header, 235, tail_at, 1)
        file.seek(0)
        file.write(header)


def test_copc_is_read_without_its_octree(tmp_path, scan):
    las = make_las("1.4", 7, scan.cloud.points[:1200])
    las.write(tmp_path / "plain.las")
    make_copc(tmp_path / "tree.copc.laz", las)
    cloud, plain = deburr.read(tmp_path / "tree.copc.laz"), deburr.read(tmp_path / "plain.las")
    assert np.array_equal(cloud.points, plain.points)
    assert all(np.array_equal(cloud[name], plain[name]) for name in plain.names)
    assert not any("copc" in block.name for block in cloud.layout.blocks)
    assert any(WKT.encode() in block.data for block in cloud.layout.blocks)


@pytest.mark.parametrize("cut", [110, 300, 700, 3000, -1])
def test_damaged_files_are_refused(tmp_path, scan, cut):
    path = tmp_path / "cut.laz"
    make_las("1.4", 7, scan.cloud.points[:600]).write(path)
    path.write_bytes(path.read_bytes()[:cut] if cut > 0 else path.read_bytes()[:-900])
    with pytest.raises(deburr.DeburrIOError, match=r"cut\.laz"):
        deburr.read(path)


def test_scans(scans, tmp_path):
    for path in scans.glob("*.laz"):
        cloud = deburr.read(path)
        with laspy.open(path) as file:
            assert len(cloud) == file.header.point_count
        deburr.write(tmp_path / path.name, cloud)
        again = deburr.read(tmp_path / path.name)
        assert again.names == cloud.names
        assert all(np.array_equal(again[name], cloud[name]) for name in cloud.names)
        assert again.layout.blocks[1:] == cloud.layout.blocks[1:]  # a header is renewed
    assert deburr.read(scans / "autzen.laz").equals(deburr.read(scans / "autzen.las"))

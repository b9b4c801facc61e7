# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import subprocess
import warnings
from pathlib import Path

import numpy as np
import pytest

import deburr

TYPES = ["int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"]


@pytest.fixture
def cloud():
    rng = np.random.default_rng(7)
    fields = {name: rng.integers(0, 100, 20).astype(name) for name in TYPES}
    fields["echoes"] = deburr.Lists(rng.random(40), np.arange(21) * 2)
    return deburr.PointCloud(rng.random((20, 3)), None, fields)


def test_ply_keeps_names_order_and_types(tmp_path, cloud):
    path = tmp_path / "cloud.ply"
    assert deburr.write(path, cloud) == []
    again = deburr.read(path)
    assert again.names == cloud.names
    assert np.array_equal(again.points, cloud.points)
    for name in TYPES:
        assert again[name].dtype == name
        assert np.array_equal(again[name], cloud[name])
    assert again["echoes"].offsets.tolist() == cloud["echoes"].offsets.tolist()
    assert again.layout.encoding == "ply-little-endian"
    assert again.layout.fields[0] == deburr.Field("x", "float64")


@pytest.mark.parametrize("name", ["cloud.ply", "cloud.pcd", "cloud.csv", "cloud.las", "cloud.obj"])
def test_a_file_survives_reading_and_writing(tmp_path, program, name):
    first, second = tmp_path / name, tmp_path / f"second_{name}"
    subprocess.run(
        [program, "synth", "cube", first, "--points", "300", "--quiet"],
        check=True,
        capture_output=True,
    )
    assert deburr.write(second, deburr.read(first)) == []
    assert second.read_bytes() == first.read_bytes()


def test_everything_beside_the_points_survives(tmp_path):
    text = b"""ply
format ascii 1.0
comment caf\xe9 is no UTF-8
obj_info a scanner
element vertex 3
property float x
property float y
property float z
property list uchar int near
element face 1
property list uchar int vertex_indices
end_header
0 0 0 2 1 2
1 0 0 0
0 1 0 1 0
3 0 1 2
"""
    path, copy = tmp_path / "mesh.ply", tmp_path / "copy.ply"
    path.write_bytes(text)
    cloud = deburr.read(path)
    assert cloud.layout.elements[0].fields["vertex_indices"][0].tolist() == [0, 1, 2]
    assert cloud.layout.obj_info == ["a scanner"]
    deburr.write(copy, cloud)
    assert copy.read_bytes() == text
    assert deburr.read_mesh(path).triangles.tolist() == [[0, 1, 2]]
    assert cloud.take([0, 1]).layout.elements == []


def test_text_fields(tmp_path):
    path, copy = tmp_path / "named.csv", tmp_path / "copy.csv"
    path.write_text("x,y,z,name,id\n0,0,0,house,1\n1,0,0,tree,2\n")
    cloud = deburr.read(path)
    assert cloud["name"].tolist() == ["house", "tree"]
    assert cloud["id"].dtype == np.int64
    deburr.write(copy, cloud)
    assert copy.read_text() == path.read_text()


@pytest.mark.parametrize("name", ["clean.ply", "clean.las", "clean.pcd", "clean.xyz", "clean.csv"])
@pytest.mark.parametrize("outliers", ["label", "remove"])
def test_a_result_is_written_as_the_program_writes_it(tmp_path, program, name, outliers, scan):
    source, theirs, ours = tmp_path / ("in_" + name), tmp_path / "theirs" / name, tmp_path / name
    theirs.parent.mkdir()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("warnings.warn", lambda *_, **__: None)  # LAS rounds
        deburr.write(source, scan.cloud)
    command = [program, "denoise", source, theirs, "--outliers", outliers, "--quiet"]
    subprocess.run(command, check=True, capture_output=True)
    deburr.write(ours, deburr.denoise(deburr.read(source), outliers=outliers))
    assert ours.read_bytes() == theirs.read_bytes()


def test_what_is_asked_for_is_written_as_the_program_writes_it(tmp_path, program, scan):
    source, theirs, ours = (tmp_path / name for name in ("in.xyz", "theirs.csv", "ours.csv"))
    deburr.write(source, scan.cloud)
    command = [program, "denoise", source, theirs, "--quiet", "--add", "label,displacement"]
    subprocess.run(command, check=True)
    result = deburr.denoise(deburr.read(source))
    deburr.write(ours, result.to_cloud(add=("label", "displacement")))
    assert ours.read_bytes() == theirs.read_bytes()


def test_what_is_lost_is_said(tmp_path, cloud):
    path = tmp_path / "cloud.obj"
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        losses = deburr.write(path, cloud)
    assert len(losses) == len(cloud.fields)
    assert "OBJ cannot hold the integers 'int8', which were left out" in losses
    assert [str(w.message) for w in caught] == [f"{path}: {loss}" for loss in losses]
    assert {w.category for w in caught} == {deburr.FormatWarning}
    assert {w.filename for w in caught} == {__file__}


def test_doubts_about_floats(tmp_path):
    path = tmp_path / "far.pcd"
    path.write_text(
        "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\n"
        "POINTS 2\nDATA binary\n",
    )
    with path.open("ab") as file:
        file.write(np.array([[5e6, 0, 0], [5e6 + 1, 0, 0]], "f4").tobytes())
    with pytest.warns(deburr.FormatWarning, match="32-bit floats"):
        deburr.read(path)


def test_errors_have_the_words_of_the_library(tmp_path, cloud):
    absent = tmp_path / "absent.ply"
    with pytest.raises(deburr.DeburrIOError, match="No such file") as caught:
        deburr.read(absent)
    assert isinstance(caught.value, OSError)
    assert issubclass(deburr.DataError, ValueError)
    assert str(caught.value).startswith(str(absent))
    short = tmp_path / "short.xyz"
    short.write_text("0 0 0\n1 2\n")
    with pytest.raises(OSError, match="line 2"):
        deburr.read(str(short))
    with pytest.raises(ValueError, match="output must end in one of"):
        deburr.write(tmp_path / "cloud.docx", cloud)
    with pytest.raises(ValueError, match="unknown format 'docx'"):
        deburr.read(short, format="docx")
    with pytest.raises(deburr.DeburrIOError):
        deburr.write(tmp_path / "no folder" / "cloud.ply", cloud)
    with pytest.raises(deburr.DataError):
        deburr.write(tmp_path / "nan.las", deburr.PointCloud(np.full((1, 3), np.nan)))
    short.write_text("0 0 0\n")
    with pytest.raises(deburr.DeburrIOError, match="face"):
        deburr.read_mesh(short)
    cloud.fields["x"] = cloud["uint8"]
    with pytest.raises(ValueError, match="two fields have the name 'x'"):
        deburr.write(tmp_path / "twice.ply", cloud)


def test_format_by_name(tmp_path, cloud):
    assert {"ply", "las", "pcd", "xyz"} <= set(deburr.format_names())
    path = tmp_path / "cloud.dat"
    deburr.write(path, cloud, format="ply")
    assert deburr.read(path, format="ply").names == cloud.names


def test_to_cloud_adds_what_is_asked_for(result):
    cloud = result.to_cloud(add=("label",))
    assert cloud.names == ["x", "y", "z", "deburr_label"]
    assert result.to_cloud().names[3:] == [
        *("nx", "ny", "nz", "deburr_label", "deburr_displacement", "deburr_outlier")
    ]
    with pytest.raises(ValueError, match="add must be of normals, label"):
        result.to_cloud(add=("colour",))


def test_scans(scans, tmp_path):
    for path in sorted(scans.iterdir()):
        if path.suffix == ".laz":
            continue
        cloud = deburr.read(path)
        assert len(cloud) > 0
        copy = tmp_path / Path(path.name)
        deburr.write(copy, cloud)
        assert deburr.read(copy).equals(cloud), path.name

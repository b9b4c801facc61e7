# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import pickle

import numpy as np
import pytest

import deburr

pd = pytest.importorskip("pandas", reason="NO PANDAS: pip install deburr[pandas]")


@pytest.fixture
def cloud():
    return deburr.PointCloud(
        [[0, 0, 0], [1, 2, 3], [4, 5, 6]],
        [[0, 0, 1]] * 3,
        {
            "intensity": np.array([1, 2, 65535], np.uint16),
            "time": np.array([0.1, np.nan, 3]),
            "name": ["a", "ü", "c"],
            "rings": deburr.Lists([1, 2, 3], [0, 2, 2, 3]),
        },
    )


def test_columns(cloud):
    assert len(cloud) == 3
    assert cloud.names == ["x", "y", "z", "nx", "ny", "nz", "intensity", "time", "name", "rings"]
    assert cloud["y"].tolist() == [0, 2, 5]
    assert cloud["nz"].tolist() == [1, 1, 1]
    assert cloud["intensity"].dtype == np.uint16
    assert np.asarray(cloud).shape == (3, 3)
    with pytest.raises(KeyError, match="no field 'colour', there are x y z"):
        cloud["colour"]


def test_structured_array_and_back(cloud):
    table = cloud.to_structured()
    assert table["time"][2] == 3
    assert table["rings"][0].tolist() == [1, 2]
    assert deburr.PointCloud.from_structured(table).equals(cloud)


def test_data_frame_and_back(cloud):
    frame = cloud.to_dataframe()
    assert isinstance(frame, pd.DataFrame)
    assert list(frame.columns) == cloud.names
    assert frame["intensity"].dtype == np.uint16
    assert deburr.PointCloud.from_dataframe(frame).equals(cloud)
    with pytest.raises(ValueError, match="x, y and z are needed, got x y"):
        deburr.PointCloud.from_dataframe(frame[["x", "y"]])


def test_pickle(cloud):
    cloud.layout.comments.append("kept")
    cloud.layout.blocks.append(deburr.HeaderBlock("LAS header", b"\0\1"))
    again = pickle.loads(pickle.dumps(cloud))
    assert again.equals(cloud)
    again.layout.comments.append("more")
    assert not again.equals(cloud)


def test_what_becomes_of_other_types():
    cloud = deburr.PointCloud(
        np.zeros((2, 3), np.float32),
        fields={
            "flag": [True, False],
            "half": np.array([1.5, 2], np.float16),
            "far": np.array([1, 2], ">i4"),
            "table": [[1, 2], [3, 4]],
            "text": np.array(["a", "bc"]),
        },
    )
    assert cloud.points.dtype == np.float64
    assert cloud["flag"].tolist() == [1, 0]
    assert [cloud[name].dtype.name for name in ("flag", "half", "far", "text")] == [
        *("uint8", "float32", "int32", "object")
    ]
    assert cloud["far"].dtype.isnative
    assert [row.tolist() for row in cloud["table"]] == [[1, 2], [3, 4]]


def test_take(cloud):
    some = cloud.take([2, 0])
    assert some["name"].tolist() == ["c", "a"]
    assert [values.tolist() for values in some["rings"]] == [[3], [1, 2]]
    assert cloud.take(cloud["x"] > 0)["intensity"].tolist() == [2, 65535]
    with pytest.raises(ValueError, match="which must have shape"):
        cloud.take([True])


def test_equals_sees_every_part(cloud):
    for change in (
        lambda c: c.points.__setitem__((0, 0), 1e-300),
        lambda c: c.fields.pop("name"),
        lambda c: c.fields.update(time=c["time"].astype(np.float32)),
        lambda c: setattr(c, "normals", None),
    ):
        other = pickle.loads(pickle.dumps(cloud))
        assert other.equals(cloud)
        change(other)
        assert not other.equals(cloud)


@pytest.mark.parametrize(
    ("arguments", "error", "words"),
    [
        ({"normals": np.zeros((2, 3))}, ValueError, "normals must have one entry per point (3)"),
        (
            {"fields": {"a": [1, 2]}},
            ValueError,
            "field 'a' must have one entry per point (3), got 2",
        ),
        ({"fields": {"a": 5}}, ValueError, "field 'a' must have shape (N,) or (N, K), got ()"),
        ({"fields": {"a": [1j] * 3}}, TypeError, "field 'a' must hold numbers or str"),
        ({"fields": {"a": [None] * 3}}, TypeError, "field 'a' must hold numbers or str"),
    ],
)
def test_what_is_no_cloud(arguments, error, words):
    with pytest.raises(error) as caught:
        deburr.PointCloud(np.zeros((3, 3)), **arguments)
    assert words in str(caught.value)


@pytest.mark.parametrize("offsets", [[], [1, 3], [0, 2], [0, 3, 2, 3], [[0, 3]]])
def test_offsets_that_are_none(offsets):
    with pytest.raises(ValueError, match="offsets"):
        deburr.Lists([1, 2, 3], np.array(offsets, dtype=int))


def test_repr_says_something(cloud):
    assert repr(cloud) == "PointCloud(3 points: x y z nx ny nz intensity time name rings)"
    html = cloud._repr_html_()
    assert "<td>intensity</td><td>uint16</td><td>1</td><td>65535</td>" in html
    assert "lists of int64" in html
    cloud.fields["<b>"] = cloud["time"]
    assert "<b>" not in cloud._repr_html_()
    assert repr(cloud["rings"]) == "Lists(3 lists of int64, 3 values)"


def test_denoise_keeps_fields_of_tables(scan):
    table = deburr.PointCloud(scan.cloud.points, fields={"id": np.arange(len(scan.cloud))})
    for given in (table.to_structured(), table.to_dataframe(), table):
        result = deburr.denoise(given, outliers="remove")
        clean = result.as_given()
        assert type(clean) is type(given)
        assert np.array_equal(clean["id"], result.kept)
        assert np.array_equal(clean["x"], result.points[:, 0])
        if not isinstance(clean, deburr.PointCloud):
            names = [*(clean.dtype.names if isinstance(clean, np.ndarray) else clean.columns)]
            assert names[:5] == ["x", "y", "z", "id", "nx"]
            assert "deburr_label" in names
    assert np.array_equal(
        deburr.denoise(scan.cloud.points).as_given(), deburr.denoise(table).points
    )

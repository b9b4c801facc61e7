# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import html.parser
import json
import pickle
import re
import subprocess
import warnings

import numpy as np
import pytest
from stand_ins import LegacyCloud, Mesh, Tensor, TensorCloud, Vectors

import deburr
from deburr import _core

HOSTILE = "\"></iframe><script>alert(1)</script>&amp;'.ply"


@pytest.fixture(autouse=True)
def _needs_the_page(request):
    if "without" not in request.node.name and not _core.has_viewer():
        pytest.skip("NOT TESTED: this build has no page, which needs Node.js")


def block(page, name):
    found = re.search(f'<script id="deburr-{name}" type="[^"]*">(.*?)</script>', page, re.S)
    return json.loads(found[1]) if found else None


class Frames(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.tags = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))


def test_before_and_after_with_the_report(scan, result):
    page = deburr.view(scan.cloud, result)
    scene = block(page.html, "scene")
    assert [cloud["name"] for cloud in scene["clouds"]] == ["before", "after"]
    assert [cloud["points"] for cloud in scene["clouds"]] == [len(result)] * 2
    assert scene["paired"]
    assert {"position", "normal", "flags", "displacement"} <= set(scene["clouds"][1]["arrays"])
    assert block(page.html, "report")["noise"] == result.report.noise
    assert page.shown == (len(result), len(result))
    assert f"{len(result)} points of after" in repr(page)
    assert result.view().html == page.html
    assert deburr.view(result).html == page.html


def test_report_is_that_of_the_program(tmp_path, program, scan):
    deburr.write(tmp_path / "in.ply", scan.cloud)
    command = [program, "denoise", "in.ply", "out.ply", "--outliers", "remove", "--json"]
    run = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True)
    theirs = json.loads(run.stdout)
    result = deburr.denoise(deburr.read(tmp_path / "in.ply"), outliers="remove")
    result.save_report(tmp_path / "report.json", names=("in.ply", "out.ply"))
    ours = json.loads((tmp_path / "report.json").read_text())
    assert [*ours] == [*theirs]
    for one in (ours, theirs):
        one["stages"] = {stage["stage"] for stage in one["stages"]} - {"read", "write"}
        del one["added_fields"]
    theirs["rms_displacement"] = pytest.approx(theirs["rms_displacement"], rel=1e-12)
    assert ours == theirs
    published = deburr.denoise(scan.cloud, method="yadav2018", rounds=2)
    command = [program, "denoise", "in.ply", "out.ply", "--method", "yadav2018", "--rounds", "2"]
    run = subprocess.run(
        [*command, "--json"], cwd=tmp_path, check=True, capture_output=True, text=True
    )
    assert published.report.options == json.loads(run.stdout)["options"]


def test_report_as_a_page(tmp_path, result):
    result.save_report(tmp_path / "report.html", names=("in.ply", "out.ply"))
    text = (tmp_path / "report.html").read_text()
    assert [cloud["name"] for cloud in block(text, "scene")["clouds"]] == ["in.ply", "out.ply"]
    assert block(text, "report")["input"] == "in.ply"


def test_frame_holds_the_page_and_nothing_else(scan):
    page = deburr.view(scan.cloud, names=HOSTILE, height=321)
    ((tag, attributes),) = Frames(page._repr_html_()).tags
    assert tag == "iframe"
    assert attributes["srcdoc"] == page.html
    assert attributes["title"] == HOSTILE
    assert "height:321px" in attributes["style"]
    assert "allow-same-origin" not in attributes["sandbox"]
    assert block(page.html, "scene")["clouds"][0]["name"] == HOSTILE
    page.height = 500
    assert "height:500px" in page._repr_html_()


def test_files_appear_whole_or_not_at_all(tmp_path, result):
    page = result.view()
    page.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text() == page.html
    (tmp_path / "folder.html").mkdir()
    with pytest.raises(deburr.DeburrIOError, match=r"folder\.html"):
        page.save(tmp_path / "folder.html")
    with pytest.raises(deburr.DeburrIOError, match="nowhere"):
        result.save_report(tmp_path / "nowhere" / "report.json")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["folder.html", "page.html"]


def test_removed_outliers_are_paired(scan):
    result = deburr.denoise(scan.cloud, outliers="remove")
    assert len(result) < len(scan.cloud)
    for page in (deburr.view(scan.cloud, result), result.view()):
        scene = block(page.html, "scene")
        assert scene["paired"]
        figures = scene["displacement"]
        assert figures["count"] == len(result)
        most = np.sqrt(np.square(result.displacement).mean())
        assert 0.9 * most < figures["rms"] < 1.001 * most
    alone = pickle.loads(pickle.dumps(deburr.denoise(scan.cloud.points)))
    assert block(alone.view().html, "scene")["clouds"][0]["points"] == len(scan.cloud)
    assert len(alone.view().shown) == 1


def test_clouds_that_are_not_the_same_points(scan):
    shuffled = np.random.default_rng(1).permutation(scan.cloud.points)
    with pytest.warns(UserWarning, match="same points"):
        page = deburr.view(scan.cloud.points, shuffled)
    assert not block(page.html, "scene")["paired"]
    assert not block(deburr.view(scan.cloud, shuffled[:99]).html, "scene")["paired"]


def test_distance_to_the_truth(scan, result):
    for truth in (scan, scan.truth, scan.clean):
        scene = block(deburr.view(scan.cloud, result, truth=truth).html, "scene")
        assert all("truth" in cloud["arrays"] for cloud in scene["clouds"])
    assert "truth" not in block(result.view().html, "scene")["clouds"][0]["arrays"]


def test_clouds_of_other_libraries_with_their_colours(scan):
    points = scan.cloud.points[:900]
    colours = np.linspace(0, 1, 2700).reshape(-1, 3)
    legacy = LegacyCloud()
    legacy.points, legacy.colors = Vectors(points), Vectors(colours)
    tensor = TensorCloud({"positions": Tensor(points), "colors": Tensor(colours)})
    mesh = Mesh(points)
    mesh.point_data["RGB"] = (255 * colours).astype(np.uint8)
    pages = [deburr.view(given) for given in (legacy, tensor, mesh)]
    fields = dict(zip(("red", "green", "blue"), colours.T, strict=True))
    wanted = deburr.view(deburr.PointCloud(points, fields=fields)).html
    assert "colour" in block(wanted, "scene")["clouds"][0]["arrays"]
    assert [page.html == wanted for page in pages[:2]] == [True, True]
    assert "colour" in block(pages[2].html, "scene")["clouds"][0]["arrays"]
    both = block(deburr.denoise(legacy, outliers="remove").view().html, "scene")["clouds"]
    assert all("colour" in cloud["arrays"] for cloud in both)
    table = deburr.PointCloud(points).to_structured()
    assert deburr.view(table).html == deburr.view(points).html


def test_what_does_not_fit_is_left_out_evenly():
    rng = np.random.default_rng(2)
    points = rng.random((150_000, 3))
    cloud = deburr.PointCloud(points, np.ones((150_000, 3)) / np.sqrt(3))
    page = deburr.view(cloud, max_size=2)
    assert len(page.html) <= 2e6
    assert 10_000 < page.shown[0] < 150_000


def test_options_are_checked(scan):
    with pytest.raises(ValueError, match=r"max_size must be in \[2, 1000\], got 1"):
        deburr.view(scan.cloud, max_size=1)
    with pytest.raises(ValueError, match="height must be >= 100, got 5"):
        deburr.view(scan.cloud, height=5)
    with pytest.raises(ValueError, match="names must be 2"):
        deburr.view(scan.cloud, scan.cloud, names=["a"])
    with pytest.raises(ValueError, match=r"shape \(N, 3\)"):
        deburr.view(scan.cloud, np.ones((3, 2)))

    with pytest.raises(ValueError, match="up must be z, y, x, -z, -y or -x, got 'w'"):
        deburr.view(scan.cloud, up="w")
    assert block(deburr.view(scan.cloud, up="-y").html, "scene")["up"] == "-y"

    def stop(stage, _):
        raise LookupError(stage)

    with pytest.raises(LookupError):
        deburr.view(scan.cloud, on_progress=stop)


def test_clouds_of_no_points():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert deburr.view([]).shown == (0,)
        assert deburr.view([[np.nan, 0, 0]]).shown == (0,)


def test_builds_without_the_page_say_so(scan, result, tmp_path, monkeypatch):
    monkeypatch.setattr(_core, "has_viewer", lambda: False)
    with pytest.raises(RuntimeError, match=r"install nodejs and npm.*DEBURR_VIEWER=ON"):
        deburr.view(scan.cloud)
    with pytest.raises(RuntimeError, match="without the page"):
        result.save_report(tmp_path / "x.html")
    result.save_report(tmp_path / "x.json")
    assert [path.name for path in tmp_path.iterdir()] == ["x.json"]

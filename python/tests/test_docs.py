# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Pages and examples do what they say."""

from __future__ import annotations

import contextlib
import doctest
import io
import re
import subprocess
import sys

import numpy as np
import pytest

import deburr
from deburr import _core

needs_the_page = pytest.mark.skipif(
    not _core.has_viewer(), reason="NOT TESTED: this build has no page, which needs Node.js"
)
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)


def blocks_of(page):
    """Pairs of a Python block and what the page says that it prints, or None."""
    text = page.read_text()
    found = list(BLOCK.finditer(text))
    for block, after in zip(found, [*found[1:], None], strict=True):
        if block[1] != "python":
            continue
        said = text[block.end() : after.start()].strip() if after else ""
        yield block[2], after[2] if after and after[1] == "" and said == "prints" else None


@needs_the_page
@pytest.mark.parametrize("name", ["README.md", "docs/python.md"])
def test_pages(documents, name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    scan = deburr.synth("part", points=1500)
    fields = {"intensity": np.arange(1500, dtype=np.uint16)}
    deburr.write("scan.ply", deburr.PointCloud(scan.cloud.points, fields=fields))
    blocks = list(blocks_of(documents / name))
    assert blocks
    names: dict[str, object] = {}
    for code, expected in blocks:
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            exec(compile(code, name, "exec"), names)
        assert out.getvalue() == (expected or ""), code


def test_docstring_of_the_package():
    failed, run = doctest.testmod(deburr)
    assert run > 3
    assert failed == 0


def test_reference_is_current(source):
    command = [sys.executable, source / "scripts" / "python_reference", "--print"]
    made = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    page = (source / "docs" / "python_reference.md").read_text()
    assert made == page, "make it anew: scripts/python_reference"


def run_example(documents, name, *arguments):
    command = [sys.executable, documents / "examples" / "python" / name, *arguments]
    run = subprocess.run(command, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return run.stdout


def test_parameter_sweep(documents):
    told = run_example(documents, "parameter_sweep.py").splitlines()
    assert len(told) == 7
    assert told[-1].startswith("best: ")


def test_open3d(documents, tmp_path, scan):
    pytest.importorskip("open3d", reason="NO OPEN3D")
    deburr.write(tmp_path / "in.ply", scan.cloud)
    told = run_example(documents, "open3d_cloud.py", tmp_path / "in.ply", tmp_path / "out.ply")
    assert f"{len(scan.cloud)} points moved by" in told
    assert deburr.read(tmp_path / "out.ply").normals is not None


def test_laz_tiles(documents, tmp_path, scan):
    pytest.importorskip("lazrs", reason="NO LAZRS: pip install deburr[las]")
    source, target = tmp_path / "in", tmp_path / "out"
    source.mkdir()
    x = scan.cloud.points[:, 0]
    halves = [scan.cloud.take(x < 50), scan.cloud.take(x >= 50)]
    for number, half in enumerate(halves):
        half.fields["intensity"] = np.arange(len(half), dtype=np.uint16)
        half.layout.resolution = 1e-6
        write_quietly(source / f"tile{number}.laz", half)
    told = run_example(documents, "laz_tiles.py", source, target, "--halo", "30")
    assert told.count("points, moved by") == 2
    whole = deburr.denoise(scan.cloud)
    for number, half in enumerate(halves):
        clean = deburr.read(target / f"tile{number}.laz")
        assert np.array_equal(clean["intensity"], half["intensity"])
        alone = deburr.metrics.compare_to_surface(clean.points, scan.truth).mean
        same = whole.points[(x < 50) if number == 0 else (x >= 50)]
        together = deburr.metrics.compare_to_surface(same, scan.truth).mean
        assert alone < 1.25 * together


def write_quietly(path, cloud):
    with pytest.warns(deburr.FormatWarning, match="LAS rounds"):
        deburr.write(path, cloud)


@needs_the_page
def test_notebook(documents, tmp_path, monkeypatch):
    nbformat = pytest.importorskip("nbformat", reason="NO NBFORMAT")
    nbclient = pytest.importorskip("nbclient", reason="NO NBCLIENT")
    for name in ("ipykernel", "matplotlib"):
        pytest.importorskip(name, reason=f"NO {name.upper()}")
    monkeypatch.delenv("MPLBACKEND", raising=False)
    monkeypatch.setenv("MPLCONFIGDIR", str(tmp_path))
    monkeypatch.delenv("DEBURR_SCAN", raising=False)
    shared = documents.parent / "shared" / "data" / "scans" / "sfm_sceaux.ply"
    if shared.exists():
        monkeypatch.setenv("DEBURR_SCAN", str(shared))
    page = nbformat.read(documents / "examples" / "python" / "tour.ipynb", as_version=4)
    assert all(not cell.get("outputs") for cell in page.cells), "outputs do not belong into git"
    nbclient.NotebookClient(page, timeout=120, resources={"metadata": {"path": tmp_path}}).execute()
    outputs = [output for cell in page.cells for output in cell.get("outputs", [])]
    kinds = {kind for output in outputs for kind in output.get("data", {})}
    assert "image/png" in kinds
    assert "<iframe" in outputs[-1]["data"]["text/html"]
    assert all(output.output_type != "error" for output in outputs)

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import pytest

import deburr

_ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(Path(__file__).parent))  # for stand_ins


@pytest.fixture(scope="session")
def source() -> Path:
    """The source tree, which is not there where a wheel is tested."""
    if not (_ROOT / "pyproject.toml").exists():
        pytest.skip("NOT TESTED: needs the source tree; a wheel is tested away from it")
    return _ROOT


@pytest.fixture(scope="session")
def documents() -> Path:
    """Where the pages and examples are; scripts/wheel copies them."""
    folder = Path(os.environ.get("DEBURR_DOCUMENTS", _ROOT))
    if not (folder / "README.md").exists():
        pytest.skip("NOT TESTED: needs README.md and docs; DEBURR_DOCUMENTS names their folder")
    return folder


@pytest.fixture(scope="session")
def scans(source: Path) -> Path:
    folder = source.parent / "shared" / "data" / "scans"
    if not folder.exists():
        pytest.skip(f"NOT TESTED: needs real scans, which are no part of the project, in {folder}")
    return folder


@pytest.fixture(scope="session")
def program() -> str:
    """The command that is installed with the package."""
    found = shutil.which("deburr", path=str(Path(sys.executable).parent))
    assert found is not None, "no command deburr beside the interpreter"
    return found


@pytest.fixture(scope="session")
def scan() -> deburr.SyntheticScan:
    return deburr.synth("part", points=2500, outliers=0.02, seed=3)


@pytest.fixture(scope="session")
def result(scan: deburr.SyntheticScan) -> deburr.Result:
    return deburr.denoise(scan.cloud)

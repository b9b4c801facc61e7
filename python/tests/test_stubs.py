# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What type checkers are told of the C++ module is what it has."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import deburr

PACKAGE = Path(deburr.__file__).parent


def test_stub_is_current(tmp_path):
    pytest.importorskip("nanobind", reason="no nanobind, whose stubgen writes the stub")
    made = tmp_path / "_core.pyi"
    command = [sys.executable, "-m", "nanobind.stubgen", "-q", "-m", "deburr._core", "-o", made]
    subprocess.run(command, check=True)
    told = "python -m nanobind.stubgen -m deburr._core -o python/deburr/_core.pyi"
    assert made.read_text() == (PACKAGE / "_core.pyi").read_text(), f"make it anew: {told}"


def test_package_is_typed():
    assert (PACKAGE / "py.typed").exists()
    assert (PACKAGE / "_core.pyi").exists()


def test_what_is_exported_is_there():
    assert sorted(deburr.__all__) == deburr.__all__
    for name in deburr.__all__:
        thing = getattr(deburr, name)
        assert name == "__version__" or thing.__doc__, f"{name} says nothing of itself"
        module = getattr(thing, "__module__", "deburr")
        assert module.split(".")[0] == "deburr"


def test_version_is_that_of_the_library():
    from importlib.metadata import version

    assert deburr.__version__ == version("deburr")

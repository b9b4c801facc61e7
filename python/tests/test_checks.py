# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Types and style of the package and the examples."""

from __future__ import annotations

import subprocess
import sys

import pytest

CHECKS = {
    "ruff": ["ruff", "check"],
    "format": ["ruff", "format", "--check"],
    "mypy": ["mypy"],
}


@pytest.mark.parametrize("name", CHECKS)
def test_check(source, name):
    tool, *arguments = CHECKS[name]
    pytest.importorskip(tool, reason=f"NO {tool.upper()}")
    run = subprocess.run(
        [sys.executable, "-m", tool, *arguments], cwd=source, capture_output=True, text=True
    )
    assert run.returncode == 0, run.stdout + run.stderr


def test_licence_headers(source):
    files = [*source.glob("python/**/*.py"), *source.glob("examples/python/*.py")]
    assert len(files) > 20
    for path in files:
        assert "SPDX-License-Identifier: Apache-2.0" in path.read_text()[:200], path

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What `deburr denoise --json` prints, of a Result."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from . import _core
from .result import Result


def denoise_summary(result: Result, source: str, target: str) -> dict[str, Any]:
    """The same keys in the same order; nothing was written, so no fields were added."""
    report = result.report.to_dict()
    last = {name: report.pop(name) for name in ("rounds", "stages")}
    return {
        "deburr_version": _core.version,
        "command": "denoise",
        "input": source,
        "output": target,
        "options": report.pop("options"),
        **report,
        "rms_displacement": result.rms_displacement,
        "max_displacement": result.max_displacement,
        **last,
        "added_fields": [],
        "warnings": [],
    }


def write(path: str | os.PathLike[str], result: Result, names: Sequence[str]) -> None:
    """Write the summary, whole or not at all."""
    line = to_line(denoise_summary(result, names[0], names[-1]))
    _core.write_whole(Path(path), line.encode())


def to_line(summary: dict[str, Any]) -> str:
    """The object on one line of ASCII; what is not finite becomes null."""
    return json.dumps(_finite(summary), separators=(",", ":")) + "\n"


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _finite(part) for name, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(part) for part in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value

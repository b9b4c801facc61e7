# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Small tables for Jupyter."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np

from .layout import FieldValues, Lists


def column(value: FieldValues) -> tuple[str, str, str]:
    """Type, smallest and largest value of a field."""
    if isinstance(value, Lists):
        return f"lists of {value.values.dtype}", "", ""
    if value.dtype.kind not in "iuf":
        return "text", "", ""
    finite = value[np.isfinite(value)]
    if not len(finite):
        return str(value.dtype), "", ""
    return str(value.dtype), f"{finite.min():.12g}", f"{finite.max():.12g}"


def table(title: str, head: Sequence[str], rows: Sequence[Sequence[Any]]) -> str:
    """A table with a title."""
    cells = "".join(f"<th>{escape(text)}</th>" for text in head)
    lines = "".join(
        "<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows
    )
    header = f"<thead><tr>{cells}</tr></thead>" if head else ""
    return f"<table><caption>{escape(title)}</caption>{header}<tbody>{lines}</tbody></table>"

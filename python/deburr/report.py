# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""What denoise() found and did, in numbers."""

from __future__ import annotations

import dataclasses
import enum
from dataclasses import dataclass
from typing import Any, NamedTuple

from . import _html


class Feature(enum.IntEnum):
    """What a point lies on; the numbers in Result.labels and in files."""

    SURFACE = 0
    EDGE = 1
    CORNER = 2
    #: Has nothing near it to be compared with, or is not finite; is never moved.
    ISOLATED = 3


class RoundReport(NamedTuple):
    """What one round of method "yadav2018" did; lengths in the unit of the input."""

    rms_move: float
    max_move: float


class StageTime(NamedTuple):
    """How long one stage took over all rounds."""

    stage: str
    seconds: float


@dataclass(frozen=True)
class Report:
    """What denoise() found and did; lengths in the unit of the input."""

    #: The options of the method as they were given or are by default; 0 stands for "find it".
    options: dict[str, str | int | float]
    #: Points that came in.
    points: int
    #: Points with a NaN or infinite coordinate; given back as they are.
    non_finite: int
    #: Points at the very place of an earlier one, or next to it; they move as that one does.
    duplicates: int
    #: Points found to be no part of the surface.
    outliers: int
    #: Points of the result: all, or all but the outliers where these are removed.
    kept: int
    #: Mean distance of a point to its 12 nearest (`k` of method "yadav2018").
    spacing: float
    #: Standard deviation of the noise as found or given, with the strength in it.
    noise: float
    #: The bound on the movement that was used.
    max_move: float
    #: Whether the first normals came from the input.
    kept_normals: bool
    #: Points of each kind: "surface", "edge", "corner", "isolated".
    labels: dict[str, int]
    #: Of method "yadav2018".
    rounds: tuple[RoundReport, ...]
    stages: tuple[StageTime, ...]

    def to_dict(self) -> dict[str, Any]:
        """Everything in plain types, as for JSON."""
        return {
            **dataclasses.asdict(self),
            "rounds": [r._asdict() for r in self.rounds],
            "stages": [s._asdict() for s in self.stages],
        }

    def rows(self) -> list[tuple[str, str]]:
        """Name and value of what a person asks for first."""
        kinds = ", ".join(f"{count} {kind}" for kind, count in self.labels.items())
        return [
            ("points", f"{self.points}, {self.kept} kept"),
            ("labels", kinds),
            ("outliers", str(self.outliers)),
            ("not finite, duplicates", f"{self.non_finite}, {self.duplicates}"),
            ("spacing", f"{self.spacing:.6g}"),
            ("noise", f"{self.noise:.6g}"),
            ("largest move allowed", f"{self.max_move:.6g}"),
            ("seconds", f"{sum(s.seconds for s in self.stages):.3g}"),
        ]

    def _repr_html_(self) -> str:
        return _html.table("deburr", (), self.rows())

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Where the scans of an E57 file stand."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._arrays import Floats


@dataclass(frozen=True)
class Pose:
    """How the coordinates of a scan become those of the file: x -> rotation x + translation."""

    rotation: NDArray[np.float64]
    translation: NDArray[np.float64]

    @classmethod
    def of_header(cls, header: dict[str, Any]) -> Pose:
        """That of the header of a scan; without one nothing is moved."""
        parts = header.get("pose", [None, {}])[1]

        def numbers(name: str, axes: str, default: list[float]) -> NDArray[np.float64]:
            found = parts.get(name, [None, {}])[1]
            if not found:
                return np.array(default)
            return np.array([float(found[axis][1]) for axis in axes])

        w, x, y, z = numbers("rotation", "wxyz", [1.0, 0.0, 0.0, 0.0])
        length = w * w + x * x + y * y + z * z
        s = 2 / length if length > 0 else 0.0
        rotation = np.array(
            [
                [1 - s * (y * y + z * z), s * (x * y - w * z), s * (x * z + w * y)],
                [s * (x * y + w * z), 1 - s * (x * x + z * z), s * (y * z - w * x)],
                [s * (x * z - w * y), s * (y * z + w * x), 1 - s * (x * x + y * y)],
            ]
        )
        return cls(rotation, numbers("translation", "xyz", [0.0, 0.0, 0.0]))

    @property
    def _moves(self) -> bool:
        return bool(np.any(self.rotation != np.eye(3)) or np.any(self.translation != 0))

    def to_file(self, points: Floats) -> Floats:
        """Points of the scan in the coordinates of the file."""
        if not self._moves:
            return points
        return np.asarray(points @ self.rotation.T + self.translation)

    def to_scan(self, points: Floats) -> Floats:
        """The reverse of to_file(), up to rounding."""
        if not self._moves:
            return points
        return np.asarray((points - self.translation) @ self.rotation)

    def turn(self, normals: NDArray[Any]) -> Floats:
        """Normals of the scan in the axes of the file."""
        return np.asarray(normals.astype(np.float64) @ self.rotation.T)

    def turn_back(self, normals: Floats) -> Floats:
        """The reverse of turn()."""
        return np.asarray(normals @ self.rotation)

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Surfaces made of triangles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ._arrays import Floats, vectors


@dataclass(frozen=True, eq=False, repr=False)
class TriangleMesh:
    """A surface made of triangles, such as the true surface that a scan is compared with.

    Parameters
    ----------
    vertices : array (V, 3)
        Becomes float64.
    triangles : array (T, 3) of integers
        Indices into vertices; becomes uint32. Counterclockwise seen from outside.

    Raises
    ------
    ValueError
        For an array of another shape, or an index that is no vertex.
    """

    vertices: Floats
    triangles: NDArray[np.uint32]

    def __post_init__(self) -> None:
        corners = np.asarray(self.triangles)
        if corners.size == 0:
            corners = corners.reshape(0, 3).astype(np.uint32)
        if corners.ndim != 2 or corners.shape[1] != 3 or corners.dtype.kind not in "iu":
            raise ValueError(
                f"triangles must be integers of shape (T, 3), got {corners.dtype} {corners.shape}"
            )
        object.__setattr__(self, "vertices", vectors("vertices", self.vertices))
        if corners.size and not 0 <= corners.min() <= corners.max() < len(self.vertices):
            raise ValueError(f"triangles must be indices of {len(self.vertices)} vertices")
        object.__setattr__(self, "triangles", np.ascontiguousarray(corners, dtype=np.uint32))

    def __repr__(self) -> str:
        return f"TriangleMesh({len(self.vertices)} vertices, {len(self.triangles)} triangles)"


def arrays_of(name: str, surface: object) -> tuple[Floats, NDArray[np.uint32]]:
    """Vertices and triangles of what has to be a mesh."""
    if not isinstance(surface, TriangleMesh):
        raise TypeError(f"{name} must be a TriangleMesh, got {type(surface).__name__}")
    return surface.vertices, surface.triangles

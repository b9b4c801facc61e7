# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""An octree whose every level has more detail, as COPC and EPT store points."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._arrays import Floats

#: A node has one point in each of so many cells along an edge, the others go to its children.
_CELLS_BITS = 7
#: Nodes of no more points are leaves that hold them all: about as many as a plane has cells.
LEAF = 1 << (2 * _CELLS_BITS)
#: Points that still share a cell here are in one node.
_DEEPEST = 20
_BITS = _DEEPEST + _CELLS_BITS

Integers = NDArray[np.int64]


class Cube(NamedTuple):
    """The root of the tree."""

    center: Floats
    half: float

    @property
    def spacing(self) -> float:
        """Between points of the root, about."""
        return float(2 * self.half / (1 << _CELLS_BITS))


@dataclass(frozen=True)
class Node:
    """Place and points of one node."""

    level: int
    x: int
    y: int
    z: int
    #: Of its points, ascending.
    indices: NDArray[np.intp]


def cube_around(points: Floats, smallest: float) -> Cube:
    """The cube on the lower corner of the points, as some readers take for granted."""
    if not len(points):
        return Cube(np.zeros(3), smallest)
    low = points.min(axis=0)
    half = max(float((points.max(axis=0) - low).max()) / 2, smallest)
    return Cube(low + half, half)


def nodes_of(points: Floats, cube: Cube, leaf: int) -> list[Node]:
    """Every point in one node; parents before their children, none of them without points.

    Parameters
    ----------
    points : array (N, 3)
        All in the cube.
    cube : Cube
    leaf : int
        A node of no more points keeps them all.
    """
    share = (points - (cube.center - cube.half)) / (2 * cube.half)
    cells = np.clip((share * (1 << _BITS)).astype(np.int64), 0, (1 << _BITS) - 1)
    rest = np.arange(len(points))
    nodes: list[Node] = []
    for level in range(_DEEPEST + 1):
        if not len(rest):
            break
        places = cells[rest] >> (_BITS - level)
        _, first, node, counts = np.unique(
            _one_number(places, _DEEPEST),
            return_index=True,
            return_inverse=True,
            return_counts=True,
        )
        stays = (counts <= leaf)[node]
        if level == _DEEPEST:
            stays[:] = True
        crowded = np.flatnonzero(~stays)
        stays[crowded[_one_per_cell(cells[rest[crowded]], level, node[crowded])]] = True
        order = np.argsort(node[stays], kind="stable")
        kept, owner = rest[stays][order], node[stays][order]
        ends = np.searchsorted(owner, np.arange(len(counts)), side="right")
        for (x, y, z), indices in zip(
            places[first].tolist(), np.split(kept, ends[:-1]), strict=True
        ):
            nodes.append(Node(level, x, y, z, indices))
        rest = rest[~stays]
    return nodes


def _one_per_cell(cells: Integers, level: int, node: Integers) -> NDArray[np.intp]:
    """The first point of each cell of each node."""
    inside = (cells >> (_BITS - level - _CELLS_BITS)) & ((1 << _CELLS_BITS) - 1)
    in_node = (node << (3 * _CELLS_BITS)) | _one_number(inside, _CELLS_BITS)
    first: NDArray[np.intp] = np.unique(in_node, return_index=True)[1]
    return first


def _one_number(places: Integers, bits: int) -> Integers:
    x, y, z = places.T
    number: Integers = (((x << bits) | y) << bits) | z
    return number

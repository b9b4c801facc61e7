# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Sharp edges and borders of a true surface, and how far points are from them."""
import numpy as np

SHARP_DEGREES = 30  # as deburr compare has it


def edges_of(vertices, triangles):
    """Every side of every triangle, in ascending order of its ends: ends, triangle, direction."""
    # Vertices at the same place count as one.
    _, same = np.unique(vertices, axis=0, return_inverse=True)
    corners = same.reshape(-1)[triangles]
    ends = np.concatenate([corners[:, [k, (k + 1) % 3]] for k in range(3)])
    raw = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    owner = np.tile(np.arange(len(triangles)), 3)
    ends = np.sort(ends, axis=1)
    order = np.lexsort((ends[:, 1], ends[:, 0]))
    return ends[order], raw[order], owner[order]


def normals_of(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    return normals / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]


def sharp_edges(vertices, triangles):
    """Segments (n, 2, 3) where the normals of two triangles differ by more than 30 degrees."""
    ends, raw, owner = edges_of(vertices, triangles)
    normals = normals_of(vertices, triangles)
    twin = np.flatnonzero((ends[:-1] == ends[1:]).all(axis=1))
    cosine = np.einsum("ij,ij->i", normals[owner[twin]], normals[owner[twin + 1]])
    return vertices[raw[twin[cosine < np.cos(np.radians(SHARP_DEGREES))]]]


def border(vertices, triangles):
    """Segments (n, 2, 3) of one triangle only, and unit vectors in its plane to its inside."""
    ends, raw, owner = edges_of(vertices, triangles)
    same = (ends[:-1] == ends[1:]).all(axis=1)
    alone = ~(np.append(same, False) | np.insert(same, 0, False))
    segments = vertices[raw[alone]]
    inwards = np.cross(normals_of(vertices, triangles)[owner[alone]],
                       segments[:, 1] - segments[:, 0])
    return segments, inwards / np.linalg.norm(inwards, axis=1)[:, None]


def nearest_segment(points, segments):
    """Distance of every point to the nearest segment, and which it is."""
    start, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    squared = np.maximum((along ** 2).sum(axis=1), 1e-300)
    distance = np.full(len(points), np.inf)
    which = np.zeros(len(points), int)
    if not len(segments):
        return distance, which
    step = max(1, 4_000_000 // len(segments))  # bounds the memory
    for first in range(0, len(points), step):
        part = points[first:first + step, None] - start
        t = np.clip(np.einsum("ijk,jk->ij", part, along) / squared, 0, 1)
        part -= t[:, :, None] * along
        d = np.einsum("ijk,ijk->ij", part, part)
        best = d.argmin(axis=1)
        which[first:first + step] = best
        distance[first:first + step] = np.sqrt(d[np.arange(len(d)), best])
    return distance, which

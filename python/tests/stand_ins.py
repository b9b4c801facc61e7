# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Clouds that have what those of other libraries have."""

from __future__ import annotations

import copy

import numpy as np


class Vectors:
    def __init__(self, array=()):
        self.array = np.array(array, float).reshape(-1, 3)

    def __array__(self, dtype=None, copy=None):
        return self.array


class LegacyCloud:
    """As open3d.geometry.PointCloud."""

    def __init__(self, other=None):
        self.points = Vectors(other.points.array) if other else Vectors()
        self.normals = Vectors(other.normals.array) if other else Vectors()
        self.colors = Vectors(other.colors.array) if other else Vectors()

    def has_normals(self):
        return len(self.normals.array) > 0

    def has_colors(self):
        return len(self.colors.array) > 0

    def select_by_index(self, indices):
        chosen = LegacyCloud()
        for name in ("points", "normals", "colors"):
            array = getattr(self, name).array
            setattr(chosen, name, Vectors(array[indices] if len(array) else array))
        return chosen


class Tensor:
    def __init__(self, array, device="CUDA:0"):
        self.array, self.device = array, device

    def cpu(self):
        return self

    def numpy(self):
        return self.array

    @classmethod
    def from_numpy(cls, array):
        return cls(array, "CPU:0")

    def to(self, device):
        return Tensor(self.array, device)


class TensorCloud:
    """As open3d.t.geometry.PointCloud."""

    def __init__(self, point):
        self.point = point

    def clone(self):
        return TensorCloud(dict(self.point))


class Mesh:
    """As pyvista.PolyData."""

    def __init__(self, points):
        self.points, self.point_data, self.faces = points, {}, None

    def copy(self):
        return copy.deepcopy(self)

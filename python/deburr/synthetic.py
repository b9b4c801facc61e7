# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Synthetic scans of which the truth is known."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from . import _core
from ._arrays import Floats, Mask, option, real, whole
from .cloud import PointCloud
from .denoising import ProgressFunction
from .mesh import TriangleMesh

Shape = Literal[
    "part",
    "cube",
    "sphere",
    "torus",
    "cylinder",
    "thin-plate",
    "bumpy-sheet",
    "stepped-wall",
]

_DEFAULTS: dict[str, Any] = _core.synth_defaults()


@dataclass(frozen=True, eq=False, repr=False)
class SyntheticScan:
    """A surface and a noisy scan of it; arrays have one entry per point of the cloud."""

    #: The noisy points, without normals.
    cloud: PointCloud
    #: The surface they were sampled from.
    truth: TriangleMesh
    #: (N, 3), the points before the noise; outliers as they are.
    clean: Floats
    #: (N, 3), unit normals of the truth at `clean`; zero for outliers.
    normals: Floats
    #: (N,) bool.
    outliers: Mask
    #: Standard deviation of the noise, in the unit of the truth.
    sigma: float
    #: sqrt(area / points), in the unit of the truth.
    spacing: float

    def __repr__(self) -> str:
        return (
            f"SyntheticScan({len(self.cloud)} points, {int(self.outliers.sum())} outliers, "
            f"noise {self.sigma:.6g}, spacing {self.spacing:.6g})"
        )


def synth(
    shape: Shape | TriangleMesh = "part",
    *,
    points: int = 100000,
    noise: float = 0.005,
    noise_unit: Literal["diagonal", "spacing"] = "diagonal",
    noise_kind: Literal["isotropic", "normal", "impulsive", "ray"] = "isotropic",
    sampling: Literal["uniform", "poisson", "scanner"] = "uniform",
    outliers: float = 0.0,
    cluster_outliers: float = 0.0,
    seed: int = 1,
    thickness: float = 0.03,
    threads: int = 0,
    on_progress: ProgressFunction | None = None,
) -> SyntheticScan:
    """Make a noisy scan of a known surface; the same seed gives the same bits on every machine.

    Parameters
    ----------
    shape : str or TriangleMesh
        "part" (100 x 60 x 40), "cube", "sphere", "torus", "cylinder", "thin-plate",
        "bumpy-sheet", "stepped-wall" (docs/synth.md has their dimensions), or any surface.
    points : int
        Number of points on the surface, 1 to 2^28.
    noise : float
        Standard deviation of the noise, in noise_unit, >= 0.
    noise_unit : "diagonal" or "spacing"
        The diagonal of the bounding box of the surface, or sqrt(area / points).
    noise_kind : "isotropic", "normal", "impulsive" or "ray"
    sampling : "uniform", "poisson" or "scanner"
    outliers, cluster_outliers : float, 0 to 1
        Outliers to add as a share of the points: uniform in twice the bounding box, and in small
        dense clusters off the surface.
    seed : int, 0 to 2^64 - 1
    thickness : float in (0, 1)
        Distance of the sheets of "thin-plate", as a fraction of the diagonal.
    threads : int, 0 to 256
    on_progress : callable, optional
        As for denoise().

    Returns
    -------
    SyntheticScan

    Raises
    ------
    ValueError
        For an option out of its range, or a mesh without triangles.
    DataError
        For a mesh without area, or without room for a cluster of outliers.
    """
    options: dict[str, Any] = {
        "points": points,
        "noise": noise,
        "noise_unit": noise_unit,
        "noise_kind": noise_kind,
        "sampling": sampling,
        "outliers": outliers,
        "cluster_outliers": cluster_outliers,
        "seed": seed,
        "thickness": thickness,
    }
    options = {name: option(_DEFAULTS[name], name, value) for name, value in options.items()}
    if not 0 <= options["seed"] < 2**64:
        raise ValueError(f"seed must be in [0, 2^64 - 1], got {seed}")
    count = whole("threads", threads)
    if isinstance(shape, TriangleMesh):
        found = _core.synthesize_mesh(shape.vertices, shape.triangles, options, count, on_progress)
    else:
        found = _core.synthesize(shape, options, count, on_progress)
    return SyntheticScan(
        cloud=PointCloud(found["points"]),
        truth=TriangleMesh(*found["truth"]),
        clean=found["clean"],
        normals=found["normals"],
        outliers=found["outlier"].view(np.bool_),
        sigma=found["sigma"],
        spacing=found["spacing"],
    )


def shape_mesh(shape: Shape, *, thickness: float = 0.03) -> TriangleMesh:
    """The surface of a shape as triangles, within 1e-5 of the diagonal of its bounding box.

    Parameters
    ----------
    shape : str
        See synth().
    thickness : float in (0, 1)
        Distance of the sheets of "thin-plate", as a fraction of the diagonal.

    Raises
    ------
    ValueError
        For an option out of its range.
    """
    return TriangleMesh(*_core.shape_mesh(shape, real("thickness", thickness)))

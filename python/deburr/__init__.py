# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Takes the noise off 3D scans (point clouds) and keeps their edges and corners sharp.

>>> import deburr
>>> scan = deburr.synth("cube", points=2000)
>>> result = deburr.denoise(scan.cloud)
>>> before = deburr.compare(scan.cloud, scan).error.mean
>>> deburr.compare(result, scan).error.mean < before / 3
True
"""

from __future__ import annotations

from . import metrics
from ._core import Neighborhoods
from ._core import version as __version__
from ._errors import Cancelled, DataError, DeburrIOError
from .cloud import PointCloud
from .comparing import Comparison, compare
from .denoising import denoise
from .features import FeatureField, classify_features
from .files import FormatWarning, format_names, read, read_mesh, write, write_mesh
from .layout import Element, Field, FileLayout, HeaderBlock, Lists
from .mesh import TriangleMesh
from .noise import (
    LocalNoise,
    NoiseEstimate,
    estimate_local_noise,
    estimate_noise,
    find_outliers,
    measure_noise,
)
from .positions import update_positions
from .report import Feature, Report, RoundReport, StageTime
from .result import Result
from .stages import (
    estimate_normals,
    filter_normals,
    find_neighbors,
    mean_neighbor_distance,
    orient_normals,
    refit_normals,
)
from .sweeps import sweep_at_once, sweep_in_place
from .synthetic import SyntheticScan, shape_mesh, synth
from .viewing import Page, view

__all__ = [
    "Cancelled",
    "Comparison",
    "DataError",
    "DeburrIOError",
    "Element",
    "Feature",
    "FeatureField",
    "Field",
    "FileLayout",
    "FormatWarning",
    "HeaderBlock",
    "Lists",
    "LocalNoise",
    "Neighborhoods",
    "NoiseEstimate",
    "Page",
    "PointCloud",
    "Report",
    "Result",
    "RoundReport",
    "StageTime",
    "SyntheticScan",
    "TriangleMesh",
    "__version__",
    "classify_features",
    "compare",
    "denoise",
    "estimate_local_noise",
    "estimate_noise",
    "estimate_normals",
    "filter_normals",
    "find_neighbors",
    "find_outliers",
    "format_names",
    "mean_neighbor_distance",
    "measure_noise",
    "metrics",
    "orient_normals",
    "read",
    "read_mesh",
    "refit_normals",
    "shape_mesh",
    "sweep_at_once",
    "sweep_in_place",
    "synth",
    "update_positions",
    "view",
    "write",
    "write_mesh",
]

# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Reading and writing files."""

from __future__ import annotations

import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from . import _bridge, _core
from ._arrays import vectors
from ._clouds import cloud_of
from .cloud import PointCloud
from .mesh import TriangleMesh
from .result import Result

PathLike = str | os.PathLike[str]


class FormatWarning(UserWarning):
    """A file holds less than it seems to, or a format cannot hold all of a cloud."""


def format_names() -> list[str]:
    """The formats that read() and write() know without extras; also the extensions of files."""
    return _core.format_names()


def read(path: PathLike, *, format: str | None = None) -> PointCloud:
    """Read a point cloud with everything that its file says.

    Parameters
    ----------
    path : str or path
        PLY, LAS, PCD, STL, OBJ, OFF or text with columns; the content tells which, then the
        extension. LAZ and COPC need `pip install deburr[las]`, E57 `pip install deburr[e57]`.
        "-" is the standard input.
    format : str, optional
        One of format_names() where the content is not to be looked at.

    Returns
    -------
    PointCloud
        Points and normals are float64, everything else keeps its type. Points of E57 are in the
        coordinates of the file, the poses of its scans applied; field `scan` tells them apart.

    Raises
    ------
    DeburrIOError
        Naming the line or byte, for a file that is missing or malformed.
    ValueError
        For a format that is not known.
    ImportError
        Naming the extra to install, for LAZ, COPC and E57 without it.

    Warns
    -----
    FormatWarning
        For coordinates stored as 32-bit floats that are too large for them.
    """
    if format is None and str(path) != "-":
        from . import _e57, _laz

        if _laz.is_compressed(Path(path)):
            return _laz.read(Path(path))
        if _e57.is_e57(Path(path)):
            return _e57.read(Path(path))
    parts, doubts = _core.read(Path(path), format or "")
    for doubt in doubts:
        warnings.warn(f"{path}: {doubt}", FormatWarning, stacklevel=2)
    return from_core(parts)


def write(
    path: PathLike, cloud: PointCloud | Result | Any, *, format: str | None = None
) -> list[str]:
    """Write a point cloud, whole or not at all.

    Within a format, encoding, header and comments are those of `cloud.layout`. Coordinates of PLY,
    OBJ, OFF and text are read back as the same doubles; LAS rounds them to its grid.

    Parameters
    ----------
    path : str or path
        The extension tells the format: one of format_names(), .laz or .copc.laz (`pip install
        deburr[las]`), or .e57 (`pip install deburr[e57]`). "-" is the standard output, as PLY.
        COPC has its points in the order of an octree.
    cloud : PointCloud, Result, array (N, 3), or whatever else denoise() takes
        Of a Result, what came in with normals, label, displacement and outlier as fields, as the
        program `deburr denoise` writes them: LAS has class 7 for outliers, and formats without
        named fields get none of these.
    format : str, optional
        One of format_names() where the extension is not to be looked at.

    Returns
    -------
    list of str
        What the format could not hold, one sentence each.

    Raises
    ------
    DeburrIOError
        If the file cannot be written; it is then as it was.
    DataError
        For coordinates that are not finite in LAS, which has no place for them.
    ValueError
        For an extension or format that is not known, for fields whose length is not that of the
        points, or for two fields of one name.

    Warns
    -----
    FormatWarning
        For everything in the list that is returned.
    """
    target = Path(path)
    suffix = target.suffix.lower() if format is None else ""
    if suffix == ".laz":
        from . import _laz

        losses = _laz.write(target, fit_to(cloud, "las", True))
    elif suffix == ".e57":
        from . import _e57

        losses = _e57.write(target, fit_to(cloud, "e57", True))
    else:
        known: Any = _core.output_format(target, format or "") or ("", False)
        if not known[0] and format is None:
            names = " ".join(f".{name}" for name in [*format_names(), "laz", "copc.laz", "e57"])
            raise ValueError(f"output must end in one of {names}, got '{path}'")
        losses = _core.write(target, to_core(fit_to(cloud, *known)), format or "")
    for loss in losses:
        warnings.warn(f"{path}: {loss}", FormatWarning, stacklevel=2)
    return losses


def read_mesh(path: PathLike) -> TriangleMesh:
    """Read a triangle mesh from a PLY, STL, OBJ or OFF file with faces.

    Faces with more than three corners are split into a fan.

    Raises
    ------
    DeburrIOError
        Also when there is no face, or one with fewer than three corners.
    """
    return TriangleMesh(*_core.read_mesh(Path(path)))


def write_mesh(path: PathLike, mesh: TriangleMesh) -> None:
    """Write a triangle mesh as binary PLY with double coordinates, whole or not at all.

    Raises
    ------
    DeburrIOError
        If the file cannot be written.
    ValueError
        If a corner is not a vertex.
    """
    _core.write_mesh(Path(path), mesh.vertices, mesh.triangles)


def from_core(parts: dict[str, Any]) -> PointCloud:
    """The cloud of what the C++ side has read."""
    fields = _bridge.fields_from_core(parts["attributes"])
    layout = _bridge.layout_from_core(parts["layout"])
    return PointCloud(parts["points"], parts["normals"], fields, layout)


def to_core(cloud: PointCloud) -> dict[str, Any]:
    """What the C++ side writes a cloud from."""
    return {
        "points": vectors("points", cloud.points),
        "normals": None if cloud.normals is None else vectors("normals", cloud.normals),
        "attributes": _bridge.fields_to_core(cloud.fields),
        "layout": _bridge.layout_to_core(cloud.layout),
    }


def fit_to(cloud: Any, format: str, takes_any_field: bool) -> PointCloud:
    """A cloud with what the program would add for a format."""
    if not isinstance(cloud, Result):
        return cloud_of(cloud)
    if not takes_any_field:
        return cloud.to_cloud(add=())
    fitted = cloud.to_cloud()
    if format == "las":
        # LAS has a class for outliers, low noise, which all its programs know.
        flags: Any = fitted.fields.pop("deburr_outlier")
        before: Any = fitted.fields.get("classification", np.zeros(len(fitted), np.uint8))
        fitted.fields["classification"] = np.where(flags, 7, before).astype(np.uint8)
    return fitted

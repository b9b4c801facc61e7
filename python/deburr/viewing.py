# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""view(): see clouds, in Jupyter or any browser."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from . import _core, _shown, _summary
from ._arrays import option, real, whole
from ._clouds import cloud_of
from .cloud import PointCloud
from .denoising import ProgressFunction
from .mesh import TriangleMesh
from .result import Result
from .synthetic import SyntheticScan

_MEGABYTE = 1e6
#: The page itself takes more than half of the least.
_LEAST, _MOST = 2, 1000
_SHORTEST = 100


@dataclass(eq=False, repr=False)
class Page:
    """A page that shows one or two clouds: one HTML file that needs no network.

    As the last value of a Jupyter cell it is shown there, where its lower edge can be dragged; the
    notebook then holds all of it.
    """

    #: Pixels that it takes in Jupyter.
    height: int
    #: What its clouds are called.
    names: tuple[str, ...]
    #: Points shown of each cloud.
    shown: tuple[int, ...]
    _html: bytes

    @property
    def html(self) -> str:
        """The whole file."""
        return self._html.decode()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the file, whole or not at all; "-" is the standard output.

        Raises
        ------
        DeburrIOError
            If it cannot be written.
        """
        _core.write_whole(Path(path), self._html)

    def __repr__(self) -> str:
        parts = [
            f"{count} points of {name}" for name, count in zip(self.names, self.shown, strict=True)
        ]
        return f"Page({len(self._html) / _MEGABYTE:.1f} MB: {', '.join(parts)})"

    def _repr_html_(self) -> str:
        # A frame of no origin: nothing in it reaches the notebook.
        return (
            f'<iframe title="{escape(" and ".join(self.names))}" '
            f'sandbox="allow-scripts allow-modals" allow="fullscreen" '
            f'style="width:100%;height:{max(int(self.height), _SHORTEST)}px;border:0;'
            f'resize:vertical;overflow:auto" srcdoc="{escape(self.html)}"></iframe>'
        )


def view(
    before: ArrayLike | PointCloud | Result | Any,
    after: ArrayLike | PointCloud | Result | Any | None = None,
    *,
    names: Sequence[str] | None = None,
    truth: TriangleMesh | PointCloud | SyntheticScan | ArrayLike | None = None,
    up: Literal["z", "y", "x", "-z", "-y", "-x"] = "z",
    height: int = 640,
    max_size: float = 12.0,
    threads: int = 0,
    on_progress: ProgressFunction | None = None,
) -> Page:
    """Show one cloud, or two with what moved between them, as the program `deburr view` does.

    Parameters
    ----------
    before : array (N, 3), PointCloud, Result, or whatever else denoise() takes
        A Result alone is shown with what it was made from, where that is still known: arrays do
        not survive pickling, and are shown as they are now.
    after : the same, optional
        Clouds of one size are taken for the same points in the same order, unless they lie too
        far apart; a Result with outliers removed knows which of `before` it kept.
    names : str or sequence of str, optional
        What the clouds are called on the page.
    truth : TriangleMesh, PointCloud, array (M, 3) or SyntheticScan, optional
        The true surface or points on it; the page then shows the distance of every point from it.
    up : "z", "y", "x", "-z", "-y" or "-x"
        The axis that points up at first; scans of objects often have "y", depth cameras "-y".
    height : int
        Pixels that the page takes in Jupyter, at least 100; its lower edge can be dragged.
    max_size : float, 2 to 1000
        Of the page, in megabytes. What does not fit is left out evenly, and the page says so.
    threads : int, 0 to 256
    on_progress : callable, optional
        As for denoise().

    Returns
    -------
    Page
        Shown by Jupyter; save(path) writes it. Points that are not finite are not shown. Where
        there are no normals, they are estimated for the shading.

    Raises
    ------
    ValueError
        For an option out of its range, an array of another shape, or another number of names than
        of clouds.
    RuntimeError
        Where deburr was installed without the page, telling how to get it.

    Warns
    -----
    UserWarning
        For clouds of one size that cannot be the same points.
    """
    size = real("max_size", max_size)
    if not _LEAST <= size <= _MOST:
        raise ValueError(f"max_size must be in [{_LEAST}, {_MOST}], got {max_size}")
    if whole("height", height) < _SHORTEST:
        raise ValueError(f"height must be >= {_SHORTEST}, got {height}")
    if not _core.has_viewer():
        raise RuntimeError(
            "deburr was installed without the page that shows clouds, which is made with Node.js "
            "18 or newer: install nodejs and npm and then deburr again, with "
            "`pip install --force-reinstall --no-deps . -C cmake.define.DEBURR_VIEWER=ON`"
        )
    result = after if after is not None else before
    if after is None and isinstance(before, Result):
        source = _shown.before_of(before)
        clouds = [cloud for cloud in (source, cloud_of(before)) if cloud is not None]
        if names is not None and not isinstance(names, str):
            names = names[-len(clouds) :]  # what came in may be gone
    else:
        clouds = [cloud_of(thing) for thing in (before, after) if thing is not None]
    called = _names(names, len(clouds))
    origin, report = None, ""
    if isinstance(result, Result) and len(clouds[0]) == result.report.points:
        report = _summary.to_line(_summary.denoise_summary(result, called[0], called[-1]))
        if len(clouds) == 2 and result.kept is not None:
            origin = np.ascontiguousarray(result.kept, dtype=np.uint32)
    count = whole("threads", threads)
    shown = [
        _shown.to_core(name, cloud, _shown.distances(cloud, truth, count))
        for name, cloud in zip(called, clouds, strict=True)
    ]
    html, points, _, doubts = _core.make_page(
        shown[0],
        shown[1] if len(shown) > 1 else None,
        origin,
        report,
        int(size * _MEGABYTE),
        option("z", "up", up),
        count,
        on_progress,
    )
    for doubt in doubts:
        warnings.warn(doubt, stacklevel=2)
    return Page(height, tuple(called), tuple(points), html)


def _names(names: Sequence[str] | None, clouds: int) -> list[str]:
    if names is None:
        return ["before", "after"] if clouds == 2 else ["cloud"]
    called = [names] if isinstance(names, str) else [*names]
    if len(called) != clouds or not all(isinstance(name, str) for name in called):
        raise ValueError(f"names must be {clouds} of str, got {names!r}")
    return called

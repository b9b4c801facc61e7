# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""denoise(), the whole method."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike

from . import _core, _foreign
from ._arrays import any_vectors, option, whole
from .report import Report, RoundReport, StageTime
from .result import Result

#: Called with the name of a stage and the fraction of the whole call that is done.
ProgressFunction = Callable[[str, float], object]

_DEFAULTS: dict[str, Any] = _core.denoise_defaults()
#: The options that only one method has.
_OWN = {
    "auto": ("strength", "max_move", "noise", "outliers"),
    "yadav2018": (
        *("rounds", "k", "rho", "tau", "damping", "alpha", "epsilon", "radius"),
        *("neighborhoods", "update"),
    ),
}
_OTHER = {"auto": "yadav2018", "yadav2018": "auto"}


def denoise(
    points: ArrayLike | Any,
    *,
    normals: ArrayLike | Literal["auto", "keep", "estimate"] | None = None,
    method: Literal["auto", "yadav2018"] = "auto",
    strength: int = 3,
    noise: float | None = None,
    max_move: float | None = None,
    outliers: Literal["label", "remove", "keep"] = "label",
    rounds: int = 50,
    k: int = 12,
    rho: float = 0.9,
    tau: float = 0.25,
    damping: float = 3.0,
    alpha: float = 0.1,
    epsilon: float = 2.0,
    radius: float = 2.0,
    neighborhoods: Literal["once", "per-round"] = "once",
    update: Literal["in-place", "simultaneous"] = "in-place",
    threads: int = 0,
    on_progress: ProgressFunction | None = None,
) -> Result:
    """Take the noise off points and keep their edges and corners.

    Method "auto" needs no option: it estimates the noise, fits the surface around every place at
    the largest scale that the noise and the surface allow, lets smooth sheets end where they meet,
    and moves each point onto them, never farther than a bound. Method "yadav2018" is the published
    program, exactly. The result has the same bits for any number of threads.

    Parameters
    ----------
    points : array (N, 3), or an object that holds points
        Coordinates in any unit, float32 or float64 of any strides, read-only too; other numbers
        become float64. Also a PointCloud, a Result, an Open3D cloud (legacy or tensor), a
        laspy.LasData, a PyVista mesh, a structured array or a pandas.DataFrame with x, y and z.
        Never changed.
    normals : array (N, 3), "auto", "keep" or "estimate", optional
        First normals of any length; those that are zero or not finite are estimated. "auto" (or
        None) keeps those that the points came with and estimates where there are none; "keep"
        refuses points without normals; "estimate" leaves them aside.
    method : "auto" or "yadav2018"
    strength : int, 1 to 5
        How much of what could be noise is taken for noise: each step makes the noise that is
        assumed larger by a factor of sqrt(2), 3 is the estimate.
    noise : float, optional
        Standard deviation of the noise in the unit of the points, >= 0; 0 or None to estimate it.
    max_move : float, optional
        No point moves farther, in the unit of the points, >= 0; 0 or None for 4 times the noise,
        less between sheets that lie close over each other.
    outliers : "label", "remove" or "keep"
        What becomes of points and small groups that are no part of the surface: they stay unmoved
        and are marked in Result.outliers, or are left out, or none are looked for.
    rounds, k, rho, tau, damping, alpha, epsilon, radius, neighborhoods, update
        Of method "yadav2018", see docs/method/denoise.md: rounds >= 0; neighbours k >= 3; rho in
        [0, 1); tau in (0, 1); damping in [0, 1e6]; alpha in (0, 1]; epsilon and radius in
        (0, 1e6], in mean distances to the k nearest; neighborhoods "once" or "per-round"; update
        "in-place" or "simultaneous".
    threads : int, 0 to 256
        0 uses every core that the process may run on.
    on_progress : callable, optional
        Called now and then with the stage (str) and the fraction of the whole (0 to 1). What it
        raises stops the work and is raised.

    Returns
    -------
    Result
        Points that are not finite, or have nothing near them to be compared with, stay as they are
        to the last bit and are labelled isolated. Fewer than 16 distinct points (4 by method
        "yadav2018") come back unchanged.

    Raises
    ------
    ValueError
        For an option out of its range or of the other method, or an array of another shape.
    DataError
        For normals to be kept where there are none.
    KeyboardInterrupt
        Within a second of Ctrl-C; nothing was changed.

    References
    ----------
    Yadav, Reitebuch, Skrodzki, Zimmermann, Polthier, Constraint-based point set denoising using
    normal voting tensor and restricted quadratic error metrics, Computers & Graphics 74, 2018.
    """
    given = _foreign.take_in(points)
    options: dict[str, Any] = {
        "method": method,
        "normals": "auto",
        "strength": strength,
        "noise": 0.0 if noise is None else noise,
        "max_move": 0.0 if max_move is None else max_move,
        "outliers": outliers,
        "rounds": rounds,
        "k": k,
        "rho": rho,
        "tau": tau,
        "damping": damping,
        "alpha": alpha,
        "epsilon": epsilon,
        "radius": radius,
        "neighborhoods": neighborhoods,
        "update": update,
    }
    first_normals = given.normals
    if isinstance(normals, str):
        options["normals"] = normals
    elif normals is not None:
        first_normals = any_vectors("normals", normals)
    options = {name: option(_DEFAULTS[name], name, value) for name, value in options.items()}
    _refuse_foreign(options)
    found = _core.denoise(
        given.points, first_normals, options, whole("threads", threads), on_progress
    )
    clean = found["points"]
    return Result(
        points=clean.astype(np.float32) if found["fits_float32"] else clean,
        normals=found["normals"],
        labels=found["labels"],
        outliers=found["outliers"].view(np.bool_),
        displacement=found["displacement"],
        report=_report(found["report"], options),
        kept=found["kept"],
        _given=given,
    )


def _refuse_foreign(options: dict[str, Any]) -> None:
    other = _OTHER.get(options["method"])
    for name in _OWN[other] if other else ():
        if options[name] != _DEFAULTS[name]:
            raise ValueError(f"{name} belongs to method '{other}'")


def _report(parts: dict[str, Any], options: dict[str, Any]) -> Report:
    used = {name: options[name] for name in ("method", "normals", *_OWN[options["method"]])}
    rounds = tuple(RoundReport(*entry) for entry in parts.pop("rounds"))
    stages = tuple(StageTime(*entry) for entry in parts.pop("stages"))
    return Report(options=used, **parts, rounds=rounds, stages=stages)

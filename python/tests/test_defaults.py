# SPDX-FileCopyrightText: 2026 The deburr authors
# SPDX-License-Identifier: Apache-2.0
"""Defaults stand in the C++ structs; what Python's signatures show has to be the same."""

from __future__ import annotations

import inspect

import pytest

import deburr
from deburr import _core


def defaults_of(function):
    return {
        name: parameter.default
        for name, parameter in inspect.signature(function).parameters.items()
        if parameter.default is not inspect.Parameter.empty
    }


def test_denoise():
    shown = defaults_of(deburr.denoise)
    stored = _core.denoise_defaults()
    # None stands for what the library calls 0, to find the length, and for "auto".
    assert stored["noise"] == stored["max_move"] == 0
    assert stored["normals"] == "auto"
    none = dict.fromkeys(("noise", "max_move", "normals"))
    assert shown == {**stored, **none, "threads": 0, "on_progress": None}


def test_synth():
    shown = defaults_of(deburr.synth)
    assert shown.pop("shape") == "part"
    assert shown == {**_core.synth_defaults(), "threads": 0, "on_progress": None}
    assert defaults_of(deburr.shape_mesh) == {"thickness": _core.synth_defaults()["thickness"]}


@pytest.mark.parametrize("name", sorted(_core.stage_defaults()))
def test_stages(name):
    shown = defaults_of(getattr(deburr, name))
    stored = dict(_core.stage_defaults()[name])
    assert shown.pop("threads") == 0
    assert shown.pop("voteless", "keep") == "keep"
    assert shown == stored


def test_sweeps_take_what_their_parts_take():
    stored = _core.stage_defaults()
    both = {**stored["classify_features"], **stored["update_positions"]}
    assert defaults_of(deburr.sweep_at_once) == {**both, "threads": 0}
    assert defaults_of(deburr.sweep_in_place) == {**both, "order": ()}


def test_view():
    stored = _core.page_defaults()["max_bytes"]
    assert defaults_of(deburr.view)["up"] == _core.page_defaults()["up"]
    for function in (deburr.view, deburr.Result.view, deburr.Result.save_report):
        assert defaults_of(function)["max_size"] * 1e6 == stored
    height = defaults_of(deburr.view)["height"]
    assert defaults_of(deburr.Result.view)["height"] == height


def test_outliers_and_coverage():
    shown = defaults_of(deburr.find_outliers)
    assert {"tolerance": shown["tolerance"]} == _core.find_outliers_defaults()
    shown = defaults_of(deburr.metrics.surface_coverage)
    assert shown == {**_core.surface_coverage_defaults(), "threads": 0}

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

// Each adds the functions of one part of the library to the module.

namespace deburr::python {

void bind_denoise(nanobind::module_& module);
void bind_files(nanobind::module_& module);
void bind_metrics(nanobind::module_& module);
void bind_neighborhoods(nanobind::module_& module);
void bind_noise(nanobind::module_& module);
void bind_stages(nanobind::module_& module);
void bind_synth(nanobind::module_& module);
void bind_view(nanobind::module_& module);

}  // namespace deburr::python

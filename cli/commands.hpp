// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace deburr::cli {

// Each adds its command to the program. Parsing the command line then runs it.

void add_denoise_command(CLI::App& program);
void add_info_command(CLI::App& program);
void add_synth_command(CLI::App& program);
void add_compare_command(CLI::App& program);
void add_view_command(CLI::App& program);
void add_render_command(CLI::App& program);

}  // namespace deburr::cli

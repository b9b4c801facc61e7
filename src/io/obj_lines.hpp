// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Lines of an OBJ file that are neither points nor plain faces, e.g. its materials, groups and
// texture coordinates, stay as they are. A block of the layout has them, and a mark for every run
// of vertices between them.

namespace deburr {

/// How the name of the block begins.
inline constexpr std::string_view obj_lines_name = "OBJ lines";

/// What no line of text begins with.
inline constexpr char obj_run_mark = '\x01';

/// The line that stands for a run of vertices.
[[nodiscard]] std::string obj_run(std::size_t vertices);

/// Whether a line of an OBJ file may begin with this word.
[[nodiscard]] bool is_obj_keyword(std::string_view word);

/// Whether a real number is one of the integers 0 to `most` divided by `most`, to the last bit:
/// what is written for colours of that many steps.
[[nodiscard]] bool is_color_step(double value, unsigned most);

}  // namespace deburr

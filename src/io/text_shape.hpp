// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/source.hpp"

namespace deburr {

/// What stands before the first point of a text file.
struct TextShape {
  TextLayout layout;
  std::vector<std::string> names;        ///< of the columns; empty for a file without points
  std::vector<std::string> comments;     ///< above the first point
  std::optional<std::size_t> announced;  ///< number of points in the count line
  std::size_t offset = 0;                ///< of the line before the first point
  std::size_t lines = 0;                 ///< before that
};

/// The text of a comment line, or nothing for another line.
struct CommentLine {
  std::string_view mark;
  std::string_view text;
};
[[nodiscard]] std::optional<CommentLine> parse_comment(std::string_view line);

/// @throws IoError  if this is no text with points in it
[[nodiscard]] TextShape find_shape(const Source& source);

}  // namespace deburr

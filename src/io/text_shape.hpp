// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/comments.hpp"
#include "io/source.hpp"

namespace deburr {

/// A block of the layout: what stands before the names of columns in a comment.
inline constexpr std::string_view text_header_mark = "text header mark";

/// What stands before the first point of a text file.
struct TextShape {
  TextLayout layout;
  std::vector<std::string> names;        ///< of the columns; empty for a file without points
  std::string header_mark;               ///< what stands before the names, where that is a comment
  std::vector<Comment> comments;         ///< above the first point
  std::optional<std::size_t> announced;  ///< number of points in the count line
  std::size_t offset = 0;                ///< of the line before the first point
  std::size_t lines = 0;                 ///< before that
};

/// The comment in a line with its outer blanks, or nothing for another line.
[[nodiscard]] std::optional<Comment> parse_comment(std::string_view raw);

/// The mark of a comment.
[[nodiscard]] std::string mark_of(const Comment& comment);

/// Whether a comment above points without a header would be taken for their header.
[[nodiscard]] bool names_columns(std::string_view comment, char separator, std::size_t columns);

/// @throws IoError  if this is no text with points in it
[[nodiscard]] TextShape find_shape(const Source& source);

}  // namespace deburr

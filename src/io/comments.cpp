// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/comments.hpp"

#include <algorithm>
#include <iterator>

namespace deburr {

void append_comments(std::string& text, const FileLayout& layout, std::string_view mark) {
  for (const auto* comments : {&layout.comments, &layout.obj_info}) {
    for (const std::string& comment : *comments) {
      text += mark;
      if (!comment.empty()) text += ' ';
      // Files of other formats begin like this, so one more blank.
      if (comment.starts_with("vtk") || comment.starts_with(".PCD")) text += ' ';
      std::ranges::transform(comment, std::back_inserter(text),
                             [](char c) { return c == '\n' || c == '\r' ? ' ' : c; });
      text += '\n';
    }
  }
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"

// Comments of files of text: a layout has their text to the last blank. What stands before it is
// kept in a block, where it is not the mark and a blank that we would write.

namespace deburr {

/// A comment as it stands in a line.
struct Comment {
  std::string before;  ///< blanks, the mark, and a blank if there is one
  std::string text;
};

/// @param line   with its outer blanks, but without its end
/// @param begin  of what stands behind the mark
[[nodiscard]] Comment comment_behind(std::string_view line, std::size_t begin);

/// Moves comments into a layout.
/// @param format  the prefix of blocks: "text", "OFF", ...
void keep_comments(FileLayout& layout, std::string_view format, std::vector<Comment> comments,
                   std::string_view mark = "#");

/// Whether a block has what stands before comments, or a header. Another format loses nothing with
/// it.
[[nodiscard]] bool is_block_of_marks(const HeaderBlock& block);

/// A control character that no line of a header can hold.
[[nodiscard]] constexpr bool ends_lines(char c) { return c == '\n' || c == '\r'; }

/// Comments and obj_info of a layout as lines of a file.
class CommentLines {
 public:
  /// @param is_bad  tells which characters the format cannot hold; they become blanks
  CommentLines(const FileLayout& layout, std::string_view format, std::string_view mark = "#",
               bool (*is_bad)(char) = ends_lines);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// Number of comments with a character that the format cannot hold.
  [[nodiscard]] std::size_t changed() const { return changed_; }
  /// Whether a file that begins with them would be taken for one of another format.
  [[nodiscard]] bool begin_like_another_format() const;

 private:
  std::string text_;
  std::size_t changed_ = 0;
};

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/comments.hpp"

#include <algorithm>
#include <utility>

namespace deburr {
namespace {

constexpr std::string_view marks_name = " comment marks";

/// What we write before a comment.
std::string usual(std::string_view mark, const std::string& text) {
  return std::string(mark) + (text.empty() ? "" : " ");
}

/// What stood before each of so many comments; empty if nothing fits.
std::vector<std::string> kept_marks(const FileLayout& layout, std::string_view format,
                                    std::size_t count) {
  std::vector<std::string> marks;
  for (const HeaderBlock& block : layout.blocks) {
    if (block.name != std::string(format) + std::string(marks_name)) continue;
    std::string_view rest = block.data;
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
      marks.emplace_back(rest.substr(0, end));
      rest.remove_prefix(end + 1);
    }
  }
  return marks.size() == count ? marks : std::vector<std::string>{};
}

}  // namespace

Comment comment_behind(std::string_view line, std::size_t begin) {
  const bool has_blank = begin < line.size() && line[begin] == ' ';
  const std::size_t at = begin + (has_blank ? 1 : 0);
  return {std::string(line.substr(0, at)), std::string(line.substr(at))};
}

void keep_comments(FileLayout& layout, std::string_view format, std::vector<Comment> comments,
                   std::string_view mark) {
  const bool are_usual = std::ranges::all_of(
      comments, [&](const Comment& c) { return c.before == usual(mark, c.text); });
  std::string marks;
  for (Comment& c : comments) {
    marks += c.before + '\n';
    layout.comments.push_back(std::move(c.text));
  }
  if (are_usual) return;
  layout.blocks.push_back({std::string(format) + std::string(marks_name), std::move(marks)});
}

bool is_block_of_marks(const HeaderBlock& block) {
  return block.name.ends_with(marks_name) || block.name.ends_with(" header mark");
}

CommentLines::CommentLines(const FileLayout& layout, std::string_view format, std::string_view mark,
                           bool (*is_bad)(char)) {
  const std::size_t count = layout.comments.size() + layout.obj_info.size();
  const std::vector<std::string> marks = kept_marks(layout, format, count);
  std::size_t k = 0;
  for (const auto* comments : {&layout.comments, &layout.obj_info}) {
    for (std::string comment : *comments) {
      text_ += marks.empty() ? usual(mark, comment) : marks[k];
      ++k;
      if (std::ranges::any_of(comment, is_bad)) ++changed_;
      std::ranges::replace_if(comment, is_bad, ' ');
      text_ += comment + '\n';
    }
  }
}

bool CommentLines::begin_like_another_format() const {
  return text_.starts_with("# vtk") || text_.starts_with("# .PCD");
}

}  // namespace deburr

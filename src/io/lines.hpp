// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace deburr {

inline constexpr std::string_view blanks = " \t\r\v\f";

/// As blanks, which are neighbours in ASCII but for the space and the line end among them.
inline constexpr bool is_blank(char c) { return c == ' ' || ('\t' <= c && c <= '\r' && c != '\n'); }

// By hand: find_first_not_of() searches in its set with a call for every character.
inline constexpr std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// Takes the next run of non-blank characters off the front of `rest`; empty at its end.
inline std::string_view next_token(std::string_view& rest) {
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  std::size_t size = 0;
  while (size < rest.size() && !is_blank(rest[size])) ++size;
  const std::string_view token = rest.substr(0, size);
  rest.remove_prefix(size);
  return token;
}

/// Number of lines, nearly: for those that no line end closes, or that end in several ways, it may
/// be too small.
inline std::size_t count_lines(std::string_view text) {
  const char end = text.find('\n') != std::string_view::npos ? '\n' : '\r';
  std::size_t count = 1;
  for (std::size_t at = text.find(end); at != std::string_view::npos; at = text.find(end, at + 1)) {
    ++count;
  }
  return count;
}

/// Goes through the lines of a text, which end with "\n" or "\r\n", and with "\r" alone where its
/// first line does.
class Lines {
 public:
  explicit Lines(std::string_view text, std::size_t offset = 0, std::size_t number = 0)
      : text_(text), offset_(offset), number_(number), newline_(text.find('\n', offset)) {
    const std::size_t first = text.find_first_of("\r\n");
    has_returns_ = first != std::string_view::npos && text[first] == '\r' &&
                   first + 1 < text.size() && text[first + 1] != '\n';
  }

  /// Steps to the next line; false at the end of the text.
  bool next() {
    if (offset_ >= text_.size()) return false;
    if (newline_ < offset_) newline_ = text_.find('\n', offset_);
    std::size_t end = std::min(newline_, text_.size());
    if (has_returns_) {
      const std::size_t mark = text_.substr(offset_, end - offset_).find('\r');
      if (mark != std::string_view::npos && offset_ + mark + 1 != newline_) end = offset_ + mark;
    }
    raw_ = text_.substr(offset_, end - offset_);
    // More than one comes of line ends that were converted twice.
    while (raw_.ends_with('\r')) raw_.remove_suffix(1);
    line_ = trim(raw_);
    offset_ = end + 1;
    ++number_;
    return true;
  }
  /// Steps to the next line that is not blank.
  bool next_full() {
    while (next()) {
      if (!line_.empty()) return true;
    }
    return false;
  }

  [[nodiscard]] std::string_view line() const { return line_; }     ///< without outer blanks
  [[nodiscard]] std::string_view raw() const { return raw_; }       ///< with them
  [[nodiscard]] std::size_t number() const { return number_; }      ///< from 1
  [[nodiscard]] std::size_t end_offset() const { return offset_; }  ///< of the line after this

 private:
  std::string_view text_;
  std::string_view line_;
  std::string_view raw_;
  std::size_t offset_;
  std::size_t number_;
  std::size_t newline_;  ///< the next one from offset_ on
  bool has_returns_ = false;
};

}  // namespace deburr

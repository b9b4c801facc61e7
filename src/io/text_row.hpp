// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>

#include "io/lines.hpp"
#include "io/numbers.hpp"
#include "io/source.hpp"
#include "io/text_split.hpp"

namespace deburr {

/// Takes words and numbers off the front of a line; what is wrong is told with its number.
class TextRow {
 public:
  TextRow(const Source& source, const Lines& lines)
      : TextRow(source, lines.number(), lines.line()) {}
  TextRow(const Source& source, std::size_t number, std::string_view line)
      : source_(&source), number_(number), rest_(line) {}

  [[noreturn]] void fail(const std::string& what) const {
    source_->fail(fmt::format("line {}: {}", number_, what));
  }

  /// The next word; empty at the end.
  std::string_view word() { return next_token(rest_); }

  [[nodiscard]] bool at_end() const { return trim(rest_).empty(); }

  /// @param what  is to be read, for the message
  template <typename T>
  T take(std::string_view what) {
    const std::string_view token = word();
    if (token.empty()) fail(fmt::format("the line ends before {}", what));
    return parse<T>(token, what);
  }

  template <typename T>
  [[nodiscard]] T parse(std::string_view token, std::string_view what) const {
    const std::optional<T> value = parse_number<T>(token);
    if (!value && is_decimal_comma(token)) fail(std::string(decimal_comma_error));
    if (!value) fail(fmt::format("'{}' is no value for {}", token, what));
    return *value;
  }

 private:
  const Source* source_;
  std::size_t number_;
  std::string_view rest_;
};

}  // namespace deburr

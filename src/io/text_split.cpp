// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/text_split.hpp"

#include <algorithm>

#include "io/lines.hpp"
#include "io/numbers.hpp"

namespace deburr {
namespace {

std::size_t count_outside_quotes(std::string_view line, char wanted) {
  std::size_t count = 0;
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == wanted && !quoted) ++count;
  }
  return count;
}

/// Position behind the quoted field that starts at `begin`, or npos.
std::size_t end_of_quotes(std::string_view line, std::size_t begin) {
  for (std::size_t i = begin + 1; i < line.size(); ++i) {
    if (line[i] != '"') continue;
    if (i + 1 == line.size() || line[i + 1] != '"') return i + 1;
    ++i;
  }
  return std::string_view::npos;
}

}  // namespace

std::string TextField::str() const {
  std::string result(text);
  if (!is_quoted) return result;
  for (std::size_t i = result.find("\"\""); i != std::string::npos;
       i = result.find("\"\"", i + 1)) {
    result.erase(i, 1);
  }
  return result;
}

char find_separator(std::string_view line) {
  for (const char separator : {';', ','}) {
    if (count_outside_quotes(line, separator) >= 2) return separator;
  }
  return line.find('\t') == std::string_view::npos ? ' ' : '\t';
}

bool split(std::string_view line, char separator, std::vector<TextField>& fields) {
  fields.clear();
  const bool at_blanks = separator == ' ' || separator == '\t';
  for (std::size_t begin = 0; begin <= line.size();) {
    while (begin < line.size() && is_blank(line[begin])) ++begin;
    if (begin == line.size() && at_blanks) break;
    std::size_t end = begin;
    const bool is_quoted = begin < line.size() && line[begin] == '"';
    if (is_quoted) end = end_of_quotes(line, begin);
    if (end == std::string_view::npos) return false;
    const std::size_t close = end;
    if (at_blanks) {
      while (end < line.size() && !is_blank(line[end])) ++end;
    } else {
      while (end < line.size() && line[end] != separator) ++end;
    }
    if (is_quoted && trim(line.substr(close, end - close)).empty()) {
      fields.push_back({line.substr(begin + 1, close - begin - 2), true});
    } else {
      fields.push_back({trim(line.substr(begin, end - begin)), false});
    }
    begin = end + 1;
  }
  return true;
}

bool is_decimal_comma(std::string_view token) {
  const std::size_t comma = token.find(',');
  if (comma == std::string_view::npos || comma + 1 == token.size()) return false;
  const std::string_view after = token.substr(comma + 1);
  return is_integer(token.substr(0, comma)) && '0' <= after[0] && after[0] <= '9' &&
         is_number(after);
}

bool has_decimal_commas(std::string_view line) {
  std::size_t tokens = 0;
  bool found = false;
  for (std::string_view token = next_token(line); !token.empty(); token = next_token(line)) {
    if (token.ends_with(',') || token.ends_with(';')) token.remove_suffix(1);
    if (is_decimal_comma(token)) {
      found = true;
    } else if (!is_number(token)) {
      return false;
    }
    ++tokens;
  }
  return found && tokens >= 3;
}

}  // namespace deburr

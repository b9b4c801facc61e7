// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/text_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "io/fields.hpp"
#include "io/lines.hpp"
#include "io/numbers.hpp"
#include "io/text_split.hpp"

namespace deburr {
namespace {

std::vector<std::string> split_names(std::string_view line, char separator) {
  std::vector<TextField> fields;
  std::vector<std::string> names;
  if (!split(line, separator, fields)) return names;
  for (const TextField& field : fields) {
    names.push_back(field.str());
    if (names.back().empty()) names.back() = fmt::format("column_{}", names.size());
  }
  return names;
}

bool names_coordinates(const std::vector<std::string>& names) {
  return missing_coordinate(find_roles(names)).empty();
}

/// The names in a header, which need not have the separator of the data; empty where no separator
/// makes as many names as there are columns, with x y z among them.
std::vector<std::string> split_header(std::string_view line, char separator, std::size_t columns) {
  for (const char other : {separator, ';', ',', ' '}) {
    std::vector<std::string> names = split_names(line, other);
    if (names.size() == columns && names_coordinates(names)) return names;
  }
  return {};
}

class ShapeFinder {
 public:
  explicit ShapeFinder(const Source& source) : source_(source), lines_(source.data) {}

  TextShape find() {
    const bool has_line = next_content();
    if (!has_line) refuse("it has comments or blank lines only");
    if (is_integer(lines_.line())) {
      shape_.announced = parse_number<std::size_t>(lines_.line());
      if (!shape_.announced) {
        source_.fail(fmt::format("line {}: {} is no number of points", lines_.number(),
                                 lines_.line().substr(0, 40)));
      }
      shape_.layout.count_line = true;
      remember_place();
      if (!next_content()) return std::move(shape_);
    }
    char separator = find_separator(lines_.line());
    if (is_header(separator)) {
      const std::string header(lines_.line());
      const std::size_t number = lines_.number();
      shape_.layout.header = TextHeader::Plain;
      remember_place();
      const bool has_row = next_content();
      if (has_row) separator = find_separator(lines_.line());
      const std::size_t columns =
          has_row ? count_columns(separator) : split_names(header, separator).size();
      take_header(header, number, separator, columns);
    } else {
      take_row(separator);
    }
    shape_.layout.separator = separator;
    check_names();
    return std::move(shape_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    source_.fail("not a point cloud: " + why);
  }

  void remember_place() {
    shape_.offset = lines_.end_offset();
    shape_.lines = lines_.number();
  }

  /// Steps to the next line that is no comment. `shape_` keeps the place before it.
  bool next_content() {
    while (lines_.next_full()) {
      std::optional<Comment> comment = parse_comment(lines_.raw());
      if (!comment) return true;
      if (shape_.comments.empty()) shape_.layout.mark = mark_of(*comment);
      shape_.comments.push_back(std::move(*comment));
      remember_place();
    }
    return false;
  }

  /// Number of columns of the first row.
  std::size_t count_columns(char separator) {
    if (has_decimal_commas(lines_.line())) {
      source_.fail(fmt::format("line {}: {}", lines_.number(), decimal_comma_error));
    }
    return split(lines_.line(), separator, fields_) ? fields_.size() : 0;
  }

  /// Whether the line is not a row: one of the first three fields, x y z, is not a number.
  bool is_header(char separator) {
    const std::size_t columns = count_columns(separator);
    if (names_coordinates(split_names(lines_.line(), separator))) return true;
    return std::any_of(
        fields_.begin(), fields_.begin() + static_cast<int>(std::min<std::size_t>(columns, 3)),
        [](const TextField& f) { return !is_number(f.text) && !is_decimal_comma(f.text); });
  }

  void take_header(const std::string& header, std::size_t number, char separator,
                   std::size_t columns) {
    const std::vector<std::string> any = split_names(header, find_separator(header));
    if (!names_coordinates(any)) {
      const std::string_view missing = missing_coordinate(find_roles(any));
      refuse(fmt::format("line {}, \"{}\", has no numbers and names no column '{}'", number,
                         header.substr(0, 60), missing));
    }
    shape_.names = split_header(header, separator, columns);
    if (shape_.names.empty()) {
      source_.fail(fmt::format("line {}: the header has {} names, the first row {} columns", number,
                               any.size(), columns));
    }
  }

  /// Names the columns of a file whose first line is a row.
  void take_row(char separator) {
    const std::size_t columns = count_columns(separator);
    if (columns < 3) {
      refuse(fmt::format("line {} has {} columns, a point needs 3", lines_.number(), columns));
    }
    for (std::size_t k = shape_.comments.size(); k-- > 0;) {
      std::vector<std::string> names = split_header(shape_.comments[k].text, separator, columns);
      if (names.empty()) continue;
      shape_.names = std::move(names);
      shape_.layout.header = TextHeader::Marked;
      shape_.header_mark = shape_.comments[k].before;
      shape_.comments.erase(shape_.comments.begin() + static_cast<std::ptrdiff_t>(k));
      return;
    }
    shape_.names = {"x", "y", "z"};
    // What surveying programs write below a count line.
    if (shape_.layout.count_line && (columns == 4 || columns == 7)) {
      shape_.names.emplace_back("intensity");
      if (columns == 7) shape_.names.insert(shape_.names.end(), {"red", "green", "blue"});
      return;
    }
    for (std::size_t k = 4; k <= columns; ++k) shape_.names.push_back(fmt::format("column_{}", k));
  }

  void check_names() const {
    std::set<std::string> seen;
    for (const std::string& name : shape_.names) {
      if (!seen.insert(name).second) {
        source_.fail(fmt::format("two columns have the name '{}'", name));
      }
    }
  }

  const Source& source_;
  Lines lines_;
  TextShape shape_;
  std::vector<TextField> fields_;
};

}  // namespace

std::optional<Comment> parse_comment(std::string_view raw) {
  std::size_t begin = 0;
  while (begin < raw.size() && is_blank(raw[begin])) ++begin;
  for (const std::string_view mark : {"#", "//"}) {
    if (raw.substr(begin).starts_with(mark)) return comment_behind(raw, begin + mark.size());
  }
  return std::nullopt;
}

std::string mark_of(const Comment& comment) { return std::string(trim(comment.before)); }

bool names_columns(std::string_view comment, char separator, std::size_t columns) {
  return !split_header(comment, separator, columns).empty();
}

TextShape find_shape(const Source& source) {
  const std::string other = name_of_other_format(source.data);
  if (!other.empty()) source.fail("not a point cloud, but " + other);
  return ShapeFinder(source).find();
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "io/comments.hpp"
#include "io/lines.hpp"
#include "io/numbers.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

struct EncodingName {
  std::string_view name;
  Encoding encoding;
};

constexpr std::array<EncodingName, 3> encodings{{
    {"ascii", Encoding::PlyAscii},
    {"binary_little_endian", Encoding::PlyLittleEndian},
    {"binary_big_endian", Encoding::PlyBigEndian},
}};

struct TypeName {
  std::string_view name;
  std::string_view sized_name;
  ScalarType type;
};

constexpr std::array<TypeName, 8> types{{{"char", "int8", ScalarType::Int8},
                                         {"uchar", "uint8", ScalarType::UInt8},
                                         {"short", "int16", ScalarType::Int16},
                                         {"ushort", "uint16", ScalarType::UInt16},
                                         {"int", "int32", ScalarType::Int32},
                                         {"uint", "uint32", ScalarType::UInt32},
                                         {"float", "float32", ScalarType::Float32},
                                         {"double", "float64", ScalarType::Float64}}};

std::string_view type_name(ScalarType type) {
  return std::ranges::find(types, type, &TypeName::type)->name;
}

class HeaderParser {
 public:
  explicit HeaderParser(const Source& source) : source_(source), lines_(source.data) {}

  PlyHeader parse() {
    lines_.next();  // "ply"
    while (lines_.next()) {
      rest_ = lines_.line();
      const std::string_view keyword = next_token(rest_);
      if (keyword == "end_header") return finish();
      if (keyword == "format") {
        parse_format();
      } else if (keyword == "comment") {
        header_.comments.push_back(free_text(keyword));
      } else if (keyword == "obj_info") {
        header_.obj_info.push_back(free_text(keyword));
      } else if (keyword == "element") {
        parse_element();
      } else if (keyword == "property") {
        parse_property();
      } else if (!keyword.empty()) {
        fail(fmt::format("unknown keyword '{}' in the header", keyword));
      }
    }
    fail("the header does not end with end_header");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    source_.fail(fmt::format("line {}: {}", lines_.number(), what));
  }

  /// What stands behind a keyword and a blank, with all other blanks.
  [[nodiscard]] std::string free_text(std::string_view keyword) const {
    return comment_behind(lines_.raw(), lines_.raw().find(keyword) + keyword.size()).text;
  }

  void expect_end() {
    const std::string_view extra = next_token(rest_);
    if (!extra.empty()) fail(fmt::format("unexpected '{}'", extra));
  }

  void parse_format() {
    const std::string_view name = next_token(rest_);
    const auto* const found = std::ranges::find(encodings, name, &EncodingName::name);
    if (found == encodings.end()) fail(fmt::format("unknown format '{}'", name));
    const std::string_view version = next_token(rest_);
    if (version != "1.0") fail(fmt::format("unknown version '{}' of PLY", version));
    expect_end();
    header_.encoding = found->encoding;
    has_format_ = true;
  }

  void parse_element() {
    PlyElement element{std::string(next_token(rest_)), 0, {}};
    const std::string_view count = next_token(rest_);
    const auto size = is_integer(count) ? parse_number<std::size_t>(count) : std::nullopt;
    if (!size) fail(fmt::format("bad number '{}' of items of element '{}'", count, element.name));
    expect_end();
    element.size = *size;
    if (std::ranges::count(header_.elements, element.name, &PlyElement::name) > 0) {
      fail(fmt::format("element '{}' appears twice", element.name));
    }
    header_.elements.push_back(element);
    names_.clear();
  }

  ScalarType parse_type() {
    const std::string_view name = next_token(rest_);
    const auto* const found = std::ranges::find_if(
        types, [&](const TypeName& t) { return t.name == name || t.sized_name == name; });
    if (found == types.end()) fail(fmt::format("unknown type '{}'", name));
    return found->type;
  }

  void parse_property() {
    if (header_.elements.empty()) fail("property before the first element");
    PlyElement& element = header_.elements.back();
    PlyProperty property;
    std::string_view after_list = rest_;
    property.is_list = next_token(after_list) == "list";
    if (property.is_list) {
      rest_ = after_list;
      property.length_type = parse_type();
      if (!is_integer_type(property.length_type)) fail("the length of a list must be an integer");
    }
    property.type = parse_type();
    property.name = next_token(rest_);
    if (property.name.empty()) fail("property without a name");
    expect_end();
    if (!names_.insert(property.name).second) {
      fail(fmt::format("element '{}' has two properties '{}'", element.name, property.name));
    }
    element.properties.push_back(property);
  }

  PlyHeader finish() {
    if (!has_format_) fail("the header has no format line");
    header_.bytes = std::min(lines_.end_offset(), source_.data.size());
    header_.lines = lines_.number();
    return std::move(header_);
  }

  const Source& source_;
  Lines lines_;
  std::string_view rest_;  ///< of the line, behind what is parsed
  PlyHeader header_;
  std::set<std::string> names_;  ///< of the properties of the last element
  bool has_format_ = false;
};

}  // namespace

PlyHeader parse_ply_header(const Source& source) { return HeaderParser(source).parse(); }

std::string format_ply_header(const PlyHeader& header) {
  const auto* const encoding =
      std::ranges::find(encodings, header.encoding, &EncodingName::encoding);
  std::string text = fmt::format("ply\nformat {} 1.0\n", encoding->name);
  const auto add_lines = [&](std::string_view keyword, const std::vector<std::string>& lines) {
    for (std::string line : lines) {
      std::ranges::replace_if(line, ends_lines, ' ');
      text += line.empty() ? fmt::format("{}\n", keyword) : fmt::format("{} {}\n", keyword, line);
    }
  };
  add_lines("comment", header.comments);
  add_lines("obj_info", header.obj_info);
  for (const PlyElement& element : header.elements) {
    text += fmt::format("element {} {}\n", element.name, element.size);
    for (const PlyProperty& p : element.properties) {
      const std::string list = p.is_list ? fmt::format("list {} ", type_name(p.length_type)) : "";
      text += fmt::format("property {}{} {}\n", list, type_name(p.type), p.name);
    }
  }
  return text + "end_header\n";
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "layout.hpp"

#include <nanobind/stl/string_view.h>

#include <string>
#include <utility>
#include <vector>

#include "text.hpp"
#include "words.hpp"

namespace deburr::python {
namespace {

namespace nb = nanobind;

constexpr Choice<ScalarType> types[] = {
    {"int8", ScalarType::Int8},       {"uint8", ScalarType::UInt8},
    {"int16", ScalarType::Int16},     {"uint16", ScalarType::UInt16},
    {"int32", ScalarType::Int32},     {"uint32", ScalarType::UInt32},
    {"int64", ScalarType::Int64},     {"uint64", ScalarType::UInt64},
    {"float32", ScalarType::Float32}, {"float64", ScalarType::Float64},
    {"str", ScalarType::Text}};
constexpr Choice<Encoding> encodings[] = {{"none", Encoding::None},
                                          {"ply-ascii", Encoding::PlyAscii},
                                          {"ply-little-endian", Encoding::PlyLittleEndian},
                                          {"ply-big-endian", Encoding::PlyBigEndian},
                                          {"text", Encoding::Text},
                                          {"pcd-ascii", Encoding::PcdAscii},
                                          {"pcd-binary", Encoding::PcdBinary},
                                          {"pcd-compressed", Encoding::PcdCompressed},
                                          {"las", Encoding::Las},
                                          {"obj", Encoding::Obj},
                                          {"off", Encoding::Off},
                                          {"stl-ascii", Encoding::StlAscii},
                                          {"stl-binary", Encoding::StlBinary}};
constexpr Choice<TextHeader> headers[] = {
    {"none", TextHeader::None}, {"plain", TextHeader::Plain}, {"marked", TextHeader::Marked}};

nb::list texts_to_python(const std::vector<std::string>& texts) {
  nb::list list;
  for (const std::string& text : texts) list.append(to_text(text));
  return list;
}

std::vector<std::string> texts_from_python(const nb::handle& list) {
  std::vector<std::string> texts;
  for (const nb::handle text : list) texts.push_back(from_text(text));
  return texts;
}

nb::tuple element_to_python(Element element) {
  nb::list attributes;
  for (Attribute& a : element.attributes) attributes.append(attribute_to_python(std::move(a)));
  return nb::make_tuple(to_text(element.name), element.size, attributes, element.before_points);
}

Element element_from_python(const nb::tuple& parts) {
  Element element{.name = from_text(parts[0]),
                  .size = nb::cast<std::size_t>(parts[1]),
                  .attributes = {},
                  .before_points = nb::cast<bool>(parts[3])};
  for (const nb::handle a : parts[2]) {
    element.attributes.push_back(attribute_from_python(nb::cast<nb::tuple>(a)));
  }
  return element;
}

}  // namespace

const char* type_word(ScalarType type) { return word_for(types, type); }

ScalarType parse_type(std::string_view word) { return parse_word("type", word, types); }

nb::dict layout_to_python(FileLayout layout) {
  nb::list fields;
  for (const Field& field : layout.fields) {
    fields.append(nb::make_tuple(to_text(field.name), type_word(field.type)));
  }
  nb::list elements;
  for (Element& element : layout.elements) elements.append(element_to_python(std::move(element)));
  nb::list blocks;
  for (const HeaderBlock& block : layout.blocks) {
    blocks.append(
        nb::make_tuple(to_text(block.name), nb::bytes(block.data.data(), block.data.size())));
  }
  nb::dict result;
  result["encoding"] = word_for(encodings, layout.encoding);
  result["separator"] = std::string_view(&layout.text.separator, 1);
  result["header"] = word_for(headers, layout.text.header);
  result["mark"] = to_text(layout.text.mark);
  result["count_line"] = layout.text.count_line;
  result["fields"] = fields;
  result["comments"] = texts_to_python(layout.comments);
  result["obj_info"] = texts_to_python(layout.obj_info);
  result["elements"] = elements;
  result["blocks"] = blocks;
  result["resolution"] = layout.resolution;
  return result;
}

FileLayout layout_from_python(const nb::dict& parts) {
  const auto word = [&](const char* name) { return nb::cast<std::string_view>(parts[name]); };
  FileLayout layout;
  layout.encoding = parse_word("encoding", word("encoding"), encodings);
  const std::string_view separator = word("separator");
  if (separator.size() != 1) throw std::invalid_argument("separator must be one character");
  layout.text = {.separator = separator.front(),
                 .header = parse_word("header", word("header"), headers),
                 .mark = from_text(parts["mark"]),
                 .count_line = nb::cast<bool>(parts["count_line"])};
  for (const nb::handle field : parts["fields"]) {
    layout.fields.push_back(
        {from_text(field[0]), parse_type(nb::cast<std::string_view>(field[1]))});
  }
  layout.comments = texts_from_python(parts["comments"]);
  layout.obj_info = texts_from_python(parts["obj_info"]);
  for (const nb::handle element : parts["elements"]) {
    layout.elements.push_back(element_from_python(nb::cast<nb::tuple>(element)));
  }
  for (const nb::handle block : parts["blocks"]) {
    const auto data = nb::cast<nb::bytes>(block[1]);
    layout.blocks.push_back({from_text(block[0]), std::string(data.c_str(), data.size())});
  }
  layout.resolution = nb::cast<double>(parts["resolution"]);
  return layout;
}

}  // namespace deburr::python

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#include "arrays.hpp"
#include "layout.hpp"
#include "text.hpp"

namespace deburr::python {
namespace {

template <typename Value>
bool copy_if_of(const nb::ndarray<nb::ro, nb::ndim<1>, nb::c_contig, nb::device::cpu>& array,
                Values& values) {
  if (array.dtype() != nb::dtype<Value>()) return false;
  const auto* const first = static_cast<const Value*>(array.data());
  values = std::vector<Value>(first, first + array.shape(0));
  return true;
}

Values values_from_python(const nb::handle& object) {
  if (nb::isinstance<nb::list>(object)) {
    std::vector<std::string> texts;
    for (const nb::handle text : nb::borrow<nb::list>(object)) texts.push_back(from_text(text));
    return texts;
  }
  const auto array =
      nb::cast<nb::ndarray<nb::ro, nb::ndim<1>, nb::c_contig, nb::device::cpu>>(object, false);
  Values values;
  const bool known =
      copy_if_of<std::int8_t>(array, values) || copy_if_of<std::uint8_t>(array, values) ||
      copy_if_of<std::int16_t>(array, values) || copy_if_of<std::uint16_t>(array, values) ||
      copy_if_of<std::int32_t>(array, values) || copy_if_of<std::uint32_t>(array, values) ||
      copy_if_of<std::int64_t>(array, values) || copy_if_of<std::uint64_t>(array, values) ||
      copy_if_of<float>(array, values) || copy_if_of<double>(array, values);
  if (!known) throw nb::type_error("a field must hold integers, float32, float64 or str");
  return values;
}

}  // namespace

nb::tuple attribute_to_python(Attribute attribute) {
  nb::object values = std::visit(
      [](auto& all) -> nb::object {
        using Value = typename std::decay_t<decltype(all)>::value_type;
        if constexpr (std::is_same_v<Value, std::string>) {
          nb::list texts;
          for (const std::string& text : all) texts.append(to_text(text));
          return texts;
        } else {
          return nb::cast(to_array(std::move(all)));
        }
      },
      attribute.values);
  nb::object offsets = nb::none();
  if (attribute.is_list()) {
    offsets = nb::cast(
        to_array(std::vector<std::uint64_t>(attribute.offsets.begin(), attribute.offsets.end())));
  }
  return nb::make_tuple(to_text(attribute.name), values, offsets, type_word(attribute.length_type));
}

Attribute attribute_from_python(const nb::tuple& parts) {
  Attribute attribute;
  attribute.name = from_text(parts[0]);
  attribute.values = values_from_python(parts[1]);
  if (!parts[2].is_none()) {
    const auto offsets = as_span(nb::cast<ValueArray<std::uint64_t>>(parts[2]));
    attribute.offsets.assign(offsets.begin(), offsets.end());
    // Checked by whoever writes the cloud, but for this, which means that there is no list.
    if (offsets.empty()) throw std::invalid_argument("the offsets of lists must begin with 0");
  }
  attribute.length_type = parse_type(nb::cast<nb::str>(parts[3]).c_str());
  return attribute;
}

nb::dict cloud_to_python(PointCloud cloud) {
  nb::dict result;
  nb::list attributes;
  for (Attribute& attribute : cloud.attributes) {
    attributes.append(attribute_to_python(std::move(attribute)));
  }
  result["points"] = to_array(std::move(cloud.points));
  result["normals"] = nb::none();
  if (!cloud.normals.empty()) result["normals"] = to_array(std::move(cloud.normals));
  result["attributes"] = attributes;
  result["layout"] = layout_to_python(std::move(cloud.layout));
  return result;
}

PointCloud cloud_from_python(const nb::dict& parts) {
  PointCloud cloud;
  const auto points = nb::cast<VectorArray>(parts["points"]);
  cloud.points.assign(as_span(points).begin(), as_span(points).end());
  if (const nb::object given = parts["normals"]; !given.is_none()) {
    const auto normals = nb::cast<VectorArray>(given);
    cloud.normals.assign(as_span(normals).begin(), as_span(normals).end());
  }
  for (const nb::handle attribute : nb::cast<nb::list>(parts["attributes"])) {
    cloud.attributes.push_back(attribute_from_python(nb::cast<nb::tuple>(attribute)));
  }
  cloud.layout = layout_from_python(nb::cast<nb::dict>(parts["layout"]));
  return cloud;
}

}  // namespace deburr::python

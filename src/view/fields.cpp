// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace deburr::view {
namespace {

constexpr double full_8_bit = 255;
constexpr double full_16_bit = 65535;
constexpr std::uint8_t low_noise = 7;  // the class of LAS

/// The value that stands for full brightness.
double full_value(const std::array<const Attribute*, 3>& channels, std::size_t points) {
  double largest = 0;
  bool whole = true;
  for (const Attribute* channel : channels) {
    if (channel->type() == ScalarType::UInt8) return full_8_bit;
    whole =
        whole && channel->type() != ScalarType::Float32 && channel->type() != ScalarType::Float64;
    for (std::size_t i = 0; i < points; ++i) largest = std::max(largest, number_at(*channel, i));
  }
  if (!whole && largest <= 1) return 1;
  return largest > full_8_bit ? full_16_bit : full_8_bit;
}

std::vector<std::uint8_t> small_numbers(const Attribute& attribute, std::size_t points) {
  std::vector<std::uint8_t> values;
  values.reserve(points);
  for (std::size_t i = 0; i < points; ++i) {
    const double value = number_at(attribute, i);
    values.push_back(value >= 0 && value <= full_8_bit ? static_cast<std::uint8_t>(value) : 0);
  }
  return values;
}

}  // namespace

const Attribute* find_numbers(const PointCloud& cloud, std::string_view name) {
  const auto found = std::ranges::find_if(cloud.attributes, [&](const Attribute& attribute) {
    return attribute.name == name && !attribute.is_list() && attribute.type() != ScalarType::Text;
  });
  return found != cloud.attributes.end() ? &*found : nullptr;
}

double number_at(const Attribute& attribute, std::size_t point) {
  return std::visit(
      [point](const auto& values) -> double {
        if constexpr (std::is_arithmetic_v<typename std::decay_t<decltype(values)>::value_type>) {
          return point < values.size() ? static_cast<double>(values[point])
                                       : std::numeric_limits<double>::quiet_NaN();
        } else {
          return std::numeric_limits<double>::quiet_NaN();
        }
      },
      attribute.values);
}

std::optional<ColourField> ColourField::of(const PointCloud& cloud) {
  constexpr std::array<std::array<std::string_view, 3>, 3> spellings{
      {{"red", "green", "blue"},
       {"r", "g", "b"},
       {"diffuse_red", "diffuse_green", "diffuse_blue"}}};
  for (const auto& names : spellings) {
    ColourField field;
    for (std::size_t k = 0; k < names.size(); ++k) {
      field.channels_[k] = find_numbers(cloud, names[k]);
    }
    if (std::ranges::find(field.channels_, nullptr) != field.channels_.end()) continue;
    field.full_ = full_value(field.channels_, cloud.size());
    return field;
  }
  return std::nullopt;
}

Rgb ColourField::operator[](std::size_t point) const {
  Rgb colour{};
  for (std::size_t k = 0; k < colour.size(); ++k) {
    const double share = number_at(*channels_[k], point) / full_;
    // Also false for NaN.
    colour[k] = share > 0
                    ? static_cast<std::uint8_t>(std::lround(std::min(share, 1.0) * full_8_bit))
                    : std::uint8_t{0};
  }
  return colour;
}

const Attribute* intensity_field(const PointCloud& cloud) {
  for (const std::string_view name :
       {"intensity", "Intensity", "scalar_Intensity", "scalar_intensity", "reflectance"}) {
    if (const Attribute* field = find_numbers(cloud, name)) return field;
  }
  return nullptr;
}

std::vector<std::uint8_t> labels_of(const PointCloud& cloud) {
  const Attribute* field = find_numbers(cloud, "deburr_label");
  return field != nullptr ? small_numbers(*field, cloud.size()) : std::vector<std::uint8_t>{};
}

std::vector<std::uint8_t> outliers_of(const PointCloud& cloud) {
  if (const Attribute* field = find_numbers(cloud, "deburr_outlier")) {
    return small_numbers(*field, cloud.size());
  }
  // Without labels the class is somebody else's opinion.
  const Attribute* classes = find_numbers(cloud, "classification");
  if (classes == nullptr || find_numbers(cloud, "deburr_label") == nullptr) return {};
  std::vector<std::uint8_t> marks = small_numbers(*classes, cloud.size());
  for (std::uint8_t& mark : marks) mark = mark == low_noise ? 1 : 0;
  return marks;
}

}  // namespace deburr::view

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"

// Fields behind those of the point format: LAS Specification 1.4 R15, table 24.

namespace deburr {

inline constexpr std::size_t las_descriptor_bytes = 192;
inline constexpr std::string_view las_undocumented = "extra_bytes";

/// A field of the extra bytes.
struct LasExtra {
  std::string name;
  ScalarType type = ScalarType::UInt8;  ///< in the file
  std::size_t count = 1;                ///< of values; more than one make a list
  bool is_scaled = false;               ///< its values are integers scale + offset, as doubles
  std::array<double, 3> scale{1, 1, 1};
  std::array<double, 3> offset{};
  std::string descriptor;  ///< as in the file; empty for bytes that nothing describes

  /// Of the attribute.
  [[nodiscard]] ScalarType value_type() const { return is_scaled ? ScalarType::Float64 : type; }
  [[nodiscard]] std::size_t bytes() const;
};

/// The fields in `size` bytes; those that no descriptor covers become one list of bytes, and
/// descriptors for which there is no room are left out.
[[nodiscard]] std::vector<LasExtra> parse_las_extras(std::string_view descriptors,
                                                     std::size_t size);

/// The integer that a scaled field has for a value; none where that reads back as another value.
template <typename T>
std::optional<T> unscale(const LasExtra& extra, std::size_t j, double value) {
  const double raw = std::nearbyint((value - extra.offset[j]) / extra.scale[j]);
  const bool fits = raw >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
                    raw <= static_cast<double>(std::numeric_limits<T>::max());
  if (!fits || std::abs(raw) > 0x1p53) return std::nullopt;
  if (raw * extra.scale[j] + extra.offset[j] != value) return std::nullopt;
  return static_cast<T>(raw);
}

/// A new field with one value per point.
[[nodiscard]] LasExtra make_las_extra(const std::string& name, ScalarType type);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "io/fields.hpp"
#include "io/las_extra.hpp"
#include "io/las_fields.hpp"
#include "io/las_header.hpp"
#include "io/losses.hpp"

namespace deburr {

/// A field of the point format and the attribute that fills it.
struct LasFieldSource {
  LasField field;
  const Attribute* attribute = nullptr;
};

/// A field of the extra bytes, and the attribute or the column of normals that fills it.
struct LasExtraSource {
  LasExtra extra;
  const Attribute* attribute = nullptr;
  const Column* normal = nullptr;
  std::size_t place = 0;  ///< in bytes, in a point
};

/// Which field of a LAS point holds which field of a cloud.
struct LasPlan {
  unsigned format = 0;
  bool has_layout = false;  ///< format and header are those of the input
  std::vector<LasFieldSource> fields;
  std::vector<LasExtraSource> extras;
  std::size_t point_bytes = 0;

  [[nodiscard]] const Attribute* attribute_for(std::string_view field) const;
};

/// @param columns   of the cloud; the plan points into them
/// @param header    of the input where that was LAS
/// @param records   of the input
/// @param losses    gets what LAS cannot hold
[[nodiscard]] LasPlan plan_las(const PointCloud& cloud, const std::vector<Column>& columns,
                               const LasHeader* header, const std::vector<LasRecord>& records,
                               Losses& losses);

/// The integer that a scaled field of extra bytes has for a value; none where it reads back as
/// another value.
template <typename T>
std::optional<T> unscale(const LasExtra& extra, std::size_t j, double value) {
  const double raw = std::nearbyint((value - extra.offset[j]) / extra.scale[j]);
  if (!(raw >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
        raw <= static_cast<double>(std::numeric_limits<T>::max()) && std::abs(raw) <= 0x1p53)) {
    return std::nullopt;
  }
  const T integer = static_cast<T>(raw);
  if (static_cast<double>(integer) * extra.scale[j] + extra.offset[j] != value) return std::nullopt;
  return integer;
}

}  // namespace deburr

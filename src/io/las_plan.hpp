// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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
  /// Whether points get one return each for want of a word about it: a point without any would be
  /// none. Where an extra field tells of returns, that of the format stays 0, and gives way to it.
  [[nodiscard]] bool makes_up(std::string_view field) const;
};

/// @param columns   of the cloud; the plan points into them
/// @param header    of the input where that was LAS
/// @param records   of the input
/// @param losses    gets what LAS cannot hold
[[nodiscard]] LasPlan plan_las(const PointCloud& cloud, const std::vector<Column>& columns,
                               const LasHeader* header, const std::vector<LasRecord>& records,
                               Losses& losses);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"

namespace deburr {

inline constexpr unsigned las_last_format = 10;
inline constexpr unsigned las_first_modern_format = 6;

/// A field of a point beside its coordinates: LAS Specification 1.4 R15, tables 8 to 18. The names
/// are those that Python programs use (laspy).
struct LasField {
  std::string_view name;
  ScalarType type = ScalarType::UInt8;
  std::size_t byte = 0;
  unsigned shift = 0;
  unsigned bits = 0;  ///< 0 for the whole type
};

/// In the order of the file.
[[nodiscard]] std::vector<LasField> las_fields(unsigned format);

/// Size of a point without extra bytes.
[[nodiscard]] std::size_t las_point_bytes(unsigned format);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/comments.hpp"
#include "io/source.hpp"

namespace deburr {

struct PcdField {
  std::string name;
  ScalarType type = ScalarType::Float32;
  std::size_t count = 1;   ///< of values
  std::size_t offset = 0;  ///< in bytes, in a point

  [[nodiscard]] bool is_padding() const { return name == "_"; }
};

inline constexpr const char* pcd_default_viewpoint = "0 0 0 1 0 0 0";

/// What the header of a PCD file says.
struct PcdHeader {
  Encoding encoding = Encoding::PcdBinary;
  std::vector<Comment> comments;  ///< that were read
  std::vector<PcdField> fields;
  std::size_t width = 0;
  std::size_t height = 1;
  std::string viewpoint = pcd_default_viewpoint;
  std::size_t point_bytes = 0;  ///< of one point in a binary file
  std::size_t bytes = 0;        ///< length of the header
  std::size_t lines = 0;

  [[nodiscard]] std::size_t points() const { return width * height; }
};

/// @throws IoError  naming the line
[[nodiscard]] PcdHeader parse_pcd_header(const Source& source);

/// @param comments  lines of them
[[nodiscard]] std::string format_pcd_header(const PcdHeader& header, std::string_view comments);

}  // namespace deburr

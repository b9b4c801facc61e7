// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/source.hpp"

namespace deburr {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::Float64;
  bool is_list = false;
  ScalarType length_type = ScalarType::UInt8;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::size_t size = 0;
  std::vector<PlyProperty> properties;
};

/// What the header of a PLY file says. The type of a property is one that PLY has.
struct PlyHeader {
  Encoding encoding = Encoding::PlyLittleEndian;
  std::vector<std::string> comments;
  std::vector<std::string> obj_info;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< length of the header
  std::size_t lines = 0;
};

/// @throws IoError  naming the line
[[nodiscard]] PlyHeader parse_ply_header(const Source& source);

[[nodiscard]] std::string format_ply_header(const PlyHeader& header);

}  // namespace deburr

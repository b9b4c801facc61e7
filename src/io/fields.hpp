// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"

// Which fields of a file are coordinates, and which columns a cloud has in a file.

namespace deburr {

/// Role of a field: one of these, or none.
inline constexpr int no_role = -1;
inline constexpr std::array<std::string_view, 6> role_names{"x", "y", "z", "nx", "ny", "nz"};
inline constexpr std::array<double Vec3::*, 3> axes{&Vec3::x, &Vec3::y, &Vec3::z};

/// The role of every name. Upper and lower case are the same; x is also found as easting and so on,
/// but only where there is no x. Normals have a role only if all three are there, named alike.
[[nodiscard]] std::vector<int> find_roles(const std::vector<std::string>& names);

/// Position of the field with this role, or the number of fields.
[[nodiscard]] std::size_t find_role(const std::vector<int>& roles, int role);

/// The first of x, y, z that no field has the role of; empty if all are there.
[[nodiscard]] std::string_view missing_coordinate(const std::vector<int>& roles);

/// One column of a file that a cloud is written to.
struct Column {
  std::string name;                       ///< of an attribute whose own one is taken, another
  ScalarType type = ScalarType::Float64;  ///< that the layout wishes
  int role = no_role;
  bool in_layout = false;
  const std::vector<Vec3>* vectors = nullptr;  ///< of a column with a role
  const Attribute* attribute = nullptr;        ///< of a column without

  /// Of a column with a role.
  [[nodiscard]] double Vec3::*axis() const { return axes[static_cast<std::size_t>(role) % 3]; }
  /// Value of item i of a column with a role.
  [[nodiscard]] double coordinate(std::size_t i) const { return (*vectors)[i].*axis(); }
};

/// All columns: first those of the layout in its order, then normals and attributes that it does
/// not name. An attribute with the name of a normal that is new gets another name.
/// @throws std::invalid_argument  if two have the same name, or sizes differ
[[nodiscard]] std::vector<Column> columns_of(const PointCloud& cloud);

}  // namespace deburr

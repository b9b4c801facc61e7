// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "deburr/vec3.hpp"
#include "io/las_header.hpp"

namespace deburr {

/// The integer of a coordinate; none outside of 32 bits.
[[nodiscard]] std::optional<std::int32_t> las_integer(double value, double scale, double offset);

/// Two lanes are what every processor has, and leave room for all that is needed in registers.
inline constexpr std::size_t las_lanes = 2;
using LasLanes = double __attribute__((vector_size(las_lanes * sizeof(double))));

/// The integers of points on a grid. They are not kept: to find them again takes less time than to
/// bring them from memory.
class LasIntegers {
 public:
  explicit LasIntegers(const LasGrid& grid);

  /// Looks at points; false if one lies outside of the grid.
  [[nodiscard]] bool survey(Points points);
  /// Whether each coordinate of all that were looked at is read back as the same double.
  [[nodiscard]] bool is_exact() const { return is_exact_; }
  /// The bounding box of what is read back, of at least one point.
  void tell_box(std::array<double, 3>& low, std::array<double, 3>& high) const;

  /// x y z of each of some points that lie inside of the grid.
  void put(Points points, std::int32_t* to) const;

 private:
  /// One value for each coordinate of two points: x y, z x, y z.
  using Group = std::array<LasLanes, 3>;

  static Group repeated(const std::array<double, 3>& values);
  bool survey_groups(Points points);
  bool survey_one_by_one(Points points);
  bool put_groups(Points points, std::int32_t* to) const;

  LasGrid grid_;
  Group scale_;
  Group offset_;
  Group inverse_{};  ///< of the scale
  Group least_;
  Group most_;
  bool is_exact_ = true;
};

}  // namespace deburr

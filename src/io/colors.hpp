// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "deburr/point_cloud.hpp"

// The colours of points: the attributes red, green and blue, and maybe alpha.

namespace deburr {

inline constexpr std::array<const char*, 4> color_names{"red", "green", "blue", "alpha"};

/// What the attributes of a cloud say of colours.
struct Colors {
  std::array<const Attribute*, 4> of{};  ///< all null if there are none; alpha may be null
  /// What stands for full brightness: 255, or 65535 as in LAS if a value is above 255; one for the
  /// three colours, one for alpha, which is 255 beside 65535 only where its type has eight bits.
  /// 0 for real numbers, whose meaning nobody knows.
  std::array<unsigned, 4> most{};

  [[nodiscard]] bool are_there() const { return of[0] != nullptr; }
  [[nodiscard]] bool are_integers() const { return most[0] > 0; }
  /// Number of attributes: 0, 3 or 4.
  [[nodiscard]] std::size_t count() const { return are_there() ? (of[3] != nullptr ? 4 : 3) : 0; }
  /// Packs integers of the points [begin, end) as 0xAARRGGBB, with eight bits each, rounded.
  void pack(std::size_t begin, std::size_t end, std::uint32_t* to) const;
};

/// The colours of a cloud: red, green and blue with one number per point, either all real numbers
/// or all integers from 0 to 65535; alpha if it is of the same kind.
[[nodiscard]] Colors find_colors(const PointCloud& cloud);

}  // namespace deburr

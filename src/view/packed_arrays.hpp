// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "box.hpp"
#include "deburr/vec3.hpp"

namespace deburr::view {

/// The arrays of a page, one after the other, with their descriptions.
class PackedArrays {
 public:
  /// Positions, 24 bits per axis over a box that holds them.
  nlohmann::ordered_json add_positions(Points points, const Box& box);
  /// Directions, two bytes each.
  nlohmann::ordered_json add_directions(Normals normals);
  /// Numbers over their range, 16 bits each, 0 exactly, and whole numbers if they fit; NaN becomes
  /// the lowest.
  nlohmann::ordered_json add_numbers(std::span<const double> values);
  /// `components` bytes per point.
  nlohmann::ordered_json add_bytes(std::span<const std::uint8_t> values, int components);

  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Bytes per point that each of these takes.
struct PointBytes {
  static constexpr std::size_t position = 9;
  static constexpr std::size_t direction = 2;
  static constexpr std::size_t number = 2;
  static constexpr std::size_t colour = 3;
  static constexpr std::size_t flags = 1;
};

}  // namespace deburr::view

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"

// What the attributes of a cloud mean to somebody who looks at it.

namespace deburr::view {

using Rgb = std::array<std::uint8_t, 3>;

/// The attribute of that name with one number per point; null where there is none.
[[nodiscard]] const Attribute* find_numbers(const PointCloud& cloud, std::string_view name);

/// Value of one point, NaN for text.
[[nodiscard]] double number_at(const Attribute& attribute, std::size_t point);

/// Colours that a file has: red green blue, or r g b, from 0 to 255, to 65535 where a value is
/// larger (LAS), or floats from 0 to 1.
class ColourField {
 public:
  /// None for a cloud without colours.
  [[nodiscard]] static std::optional<ColourField> of(const PointCloud& cloud);
  [[nodiscard]] Rgb operator[](std::size_t point) const;

 private:
  std::array<const Attribute*, 3> channels_{};
  double full_ = 255;  ///< value of the brightest
};

/// The field "intensity", or the names that other programs give it; null where there is none.
[[nodiscard]] const Attribute* intensity_field(const PointCloud& cloud);

/// deburr_label of every point; empty where the cloud has none.
[[nodiscard]] std::vector<std::uint8_t> labels_of(const PointCloud& cloud);

/// 1 for every point that deburr_outlier marks, or the class 7 of a LAS file that deburr has
/// written; empty where the cloud tells nothing.
[[nodiscard]] std::vector<std::uint8_t> outliers_of(const PointCloud& cloud);

}  // namespace deburr::view

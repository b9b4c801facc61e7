// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace deburr::view {

/// Numbers of many values, in their unit. NaN and infinite ones do not count.
struct Summary {
  std::size_t count = 0;
  double mean = 0;           ///< of the magnitudes
  double rms = 0;            ///< root of the mean square
  double percentile_95 = 0;  ///< the smallest magnitude that 95 % of all do not exceed
  double maximum = 0;        ///< largest magnitude
};

[[nodiscard]] Summary summarise(std::span<const double> values);

/// The magnitude that this share of the finite values does not exceed; 0 where there are none.
[[nodiscard]] double magnitude_quantile(std::span<const double> values, double share);

/// How many values lie in each of equal parts of [low, high].
struct Histogram {
  double low = 0;
  double high = 0;
  std::vector<std::size_t> counts;
  std::size_t below = 0;
  std::size_t above = 0;
};

/// @param high  upper end of the range; it begins at 0, or at -high where a value is negative
[[nodiscard]] Histogram histogram_of(std::span<const double> values, double high, std::size_t bins);

}  // namespace deburr::view

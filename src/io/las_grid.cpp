// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/fields.hpp"
#include "io/numbers.hpp"

namespace deburr {
namespace {

constexpr double largest_integer = std::numeric_limits<std::int32_t>::max();

/// The double nearest to a power of ten.
double power_of_ten(int exponent) {
  return parse_number<double>(fmt::format("1e{}", exponent)).value_or(0);
}

/// Smallest exponent with limit * 10^exponent >= size, as far as doubles go.
int exponent_for(double size, double limit) {
  constexpr int least = -300;
  constexpr int most = 299;
  const double guess = size > 0 ? std::floor(std::log10(size / limit)) - 1 : least;
  int exponent = static_cast<int>(std::clamp<double>(guess, least, most));
  while (exponent < most && power_of_ten(exponent) * limit < size) ++exponent;
  return exponent;
}

bool reads_back(const LasGrid& grid, Points points) {
  return std::ranges::all_of(points, [&](const Vec3& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = p.*axes[k];
      const auto integer = las_integer(value, grid.scale[k], grid.offset[k]);
      if (!integer || *integer * grid.scale[k] + grid.offset[k] != value) return false;
    }
    return true;
  });
}

}  // namespace

std::optional<std::int32_t> las_integer(double value, double scale, double offset) {
  const double integer = std::nearbyint((value - offset) / scale);
  const double held = std::clamp(integer, -largest_integer - 1, largest_integer);
  // The last integers may be missed by a rounding of the difference. A NaN is never equal.
  if (held != integer && held * scale + offset != value) return std::nullopt;
  return static_cast<std::int32_t>(held);
}

std::optional<GridChoice> refine_grid(const LasGrid& old, Points points, double resolution) {
  GridChoice choice{old};
  for (std::size_t k = 0; k < 3; ++k) {
    double largest = 0;
    for (const Vec3& p : points) {
      if (!las_integer(p.*axes[k], old.scale[k], old.offset[k])) return std::nullopt;
      largest = std::max(largest, std::abs((p.*axes[k] - old.offset[k]) / old.scale[k]));
    }
    double& scale = choice.grid.scale[k];
    if (!(resolution > 0)) continue;
    while (std::abs(scale) > resolution) {
      largest *= 2;
      if (largest > largest_integer - 1) {
        choice.is_coarse = true;
        break;
      }
      scale /= 2;
    }
  }
  choice.is_exact = reads_back(choice.grid, points);
  return choice;
}

GridChoice choose_grid(Points points) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{infinity, infinity, infinity};
  std::array<double, 3> high{-infinity, -infinity, -infinity};
  for (const Vec3& p : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p.*axes[k]);
      high[k] = std::max(high[k], p.*axes[k]);
    }
  }
  GridChoice choice;
  double half = 0;
  for (std::size_t k = 0; k < 3 && !points.empty(); ++k) {
    half = std::max(half, high[k] / 2 - low[k] / 2);
  }
  // A quarter of the integers is left for the offset, which is a round number near the middle.
  constexpr double for_points = 1.5e9;
  const int exponent = half > 0 ? exponent_for(half, for_points) : -3;
  const double round = power_of_ten(exponent + 9);
  for (std::size_t k = 0; k < 3; ++k) {
    const double middle = points.empty() ? 0 : low[k] / 2 + high[k] / 2;
    choice.grid.scale[k] = power_of_ten(exponent);
    choice.grid.offset[k] = half > 0 ? std::round(middle / round) * round : middle;
  }
  choice.is_exact = reads_back(choice.grid, points);
  return choice;
}

}  // namespace deburr

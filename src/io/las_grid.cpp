// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/fields.hpp"
#include "io/large_pages.hpp"
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

/// The nearest integer, ties to even, of a number below 2^51. Faster than a call of nearbyint().
double nearest(double value) {
  constexpr double large = 0x1.8p52;
  return (value + large) - large;
}

/// Fills in all but the grid; false if a point lies outside of it.
bool put_on_grid(GridChoice& choice, Points points) {
  const LasGrid& grid = choice.grid;
  choice.integers.clear();
  resize_large(choice.integers, 3 * points.size());
  choice.is_exact = true;
  std::array<std::int32_t, 3> least{};
  std::array<std::int32_t, 3> most{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = points[i].*axes[k];
      const double quick = nearest((value - grid.offset[k]) / grid.scale[k]);
      std::int32_t integer = 0;
      if (std::abs(quick) < largest_integer) {
        integer = static_cast<std::int32_t>(quick);
      } else if (const auto held = las_integer(value, grid.scale[k], grid.offset[k])) {
        integer = *held;
      } else {
        return false;
      }
      choice.is_exact = choice.is_exact && integer * grid.scale[k] + grid.offset[k] == value;
      choice.integers[3 * i + k] = integer;
      least[k] = i == 0 ? integer : std::min(least[k], integer);
      most[k] = i == 0 ? integer : std::max(most[k], integer);
    }
  }
  for (std::size_t k = 0; k < 3 && !points.empty(); ++k) {
    const double a = least[k] * grid.scale[k] + grid.offset[k];
    const double b = most[k] * grid.scale[k] + grid.offset[k];
    choice.low[k] = std::min(a, b);
    choice.high[k] = std::max(a, b);
  }
  return true;
}

}  // namespace

std::optional<std::int32_t> las_integer(double value, double scale, double offset) {
  const double real = (value - offset) / scale;
  constexpr double safe = 0x1p51;
  const double integer = std::abs(real) < safe ? nearest(real) : real;
  const double held = std::clamp(integer, -largest_integer - 1, largest_integer);
  // The last integers may be missed by a rounding of the difference. A NaN is never equal.
  if (held != integer && held * scale + offset != value) return std::nullopt;
  return static_cast<std::int32_t>(held);
}

std::optional<GridChoice> refine_grid(const LasGrid& old, Points points, double resolution) {
  GridChoice choice;
  choice.grid = old;
  if (!put_on_grid(choice, points)) return std::nullopt;
  if (!(resolution > 0)) return choice;
  for (std::size_t k = 0; k < 3; ++k) {
    double& scale = choice.grid.scale[k];
    const double ends[] = {(choice.low[k] - old.offset[k]) / scale,
                           (choice.high[k] - old.offset[k]) / scale};
    double largest = std::max(std::abs(ends[0]), std::abs(ends[1])) + 1;
    bool is_coarse = false;
    while (std::abs(scale) > resolution && !is_coarse) {
      largest *= 2;
      is_coarse = largest > largest_integer;
      if (!is_coarse) scale /= 2;
    }
    choice.is_coarse = choice.is_coarse || is_coarse;
  }
  if (choice.grid.scale != old.scale && !put_on_grid(choice, points)) return std::nullopt;
  return choice;
}

std::optional<GridChoice> choose_grid(Points points) {
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
  if (!put_on_grid(choice, points)) return std::nullopt;
  return choice;
}

}  // namespace deburr

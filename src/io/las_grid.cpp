// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/las_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/fields.hpp"
#include "io/las_integers.hpp"
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

/// Fills in all but the grid; false if a point lies outside of it.
bool put_on_grid(GridChoice& choice, Points points) {
  LasIntegers integers(choice.grid);
  if (!integers.survey(points)) return false;
  choice.is_exact = integers.is_exact();
  if (!points.empty()) integers.tell_box(choice.low, choice.high);
  return true;
}

}  // namespace

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

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/left_out.hpp"

#include <algorithm>
#include <cmath>

#include "view/fields.hpp"
#include "view/statistics.hpp"

namespace deburr::view {
namespace {

// How well a distance between two files has to agree with the field: the field has 32 bits, and so
// may coordinates have; formats with a grid round to a thirtieth of the movement.
constexpr double of_distance = 1e-3;
constexpr double of_movement = 0.05;  // root mean square
constexpr double of_coordinate = 4e-7;

double largest_coordinate(Points points) {
  double largest = 0;
  for (const Vec3& p : points) {
    if (!is_finite(p)) continue;
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return largest;
}

}  // namespace

std::vector<std::uint32_t> match_without_removed(const PointCloud& before,
                                                 const PointCloud& after) {
  const Attribute* const field = find_numbers(after, "deburr_displacement");
  if (field == nullptr || after.size() >= before.size()) return {};
  std::vector<double> moved;
  moved.reserve(after.size());
  for (std::size_t i = 0; i < after.size(); ++i) moved.push_back(number_at(*field, i));
  const double tolerance =
      of_movement * summarise(moved).rms + of_coordinate * largest_coordinate(before.points);
  const auto fits = [&](std::size_t i, std::size_t k) {
    if (!is_finite(after.points[i])) return !is_finite(before.points[k]);
    const double distance = norm(after.points[i] - before.points[k]);
    return std::abs(distance - moved[i]) <= of_distance * moved[i] + tolerance;
  };
  // The first that fits leaves the most for those that follow: whoever fails so, fails.
  std::vector<std::uint32_t> origin;
  origin.reserve(after.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < after.size(); ++i, ++k) {
    while (k < before.size() && !fits(i, k)) ++k;
    if (k == before.size()) return {};
    origin.push_back(static_cast<std::uint32_t>(k));
  }
  return origin;
}

}  // namespace deburr::view

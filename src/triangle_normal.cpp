// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "triangle_normal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace deburr {

double largest_coordinate(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

Vec3 triangle_normal(const Triangle& triangle) {
  Vec3 ab = triangle[1] - triangle[0];
  Vec3 ac = triangle[2] - triangle[0];
  // The square of an area would vanish or overflow long before the lengths do.
  const double size = std::max(largest_coordinate(ab), largest_coordinate(ac));
  if (size == 0) return {};
  ab = (1 / size) * ab;
  ac = (1 / size) * ac;
  const Vec3 across = cross(ab, ac);
  const double twice_area = norm(across);
  const double longest =
      std::sqrt(std::max({squared_norm(ab), squared_norm(ac), squared_norm(ac - ab)}));
  double rounding = 0;
  for (const Vec3& corner : triangle) rounding = std::max(rounding, largest_coordinate(corner));
  rounding *= 4 * std::numeric_limits<double>::epsilon() / size;
  if (!(twice_area > rounding * longest)) return {};
  return (1 / twice_area) * across;
}

}  // namespace deburr

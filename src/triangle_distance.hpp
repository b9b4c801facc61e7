// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "deburr/vec3.hpp"

namespace deburr {

using Triangle = std::array<Vec3, 3>;

/// The nearest point of a triangle, and how far it is.
struct NearestOnTriangle {
  Vec3 offset;  ///< from the point that was asked for
  double squared_distance;
};

/// The point of a triangle that is nearest to a point. A triangle without area is the segment or
/// the point that its corners span.
///
/// Only differences of coordinates enter, so an offset common to all costs nothing. The distance is
/// always measured to a point of the triangle; for thin triangles, too, it is off by no more than a
/// few roundings of the length of the triangle or of the distance, whichever is larger.
[[nodiscard]] NearestOnTriangle nearest_on(const Vec3& p, const Triangle& triangle);

/// The distance alone.
[[nodiscard]] inline double squared_distance(const Vec3& p, const Triangle& triangle) {
  return nearest_on(p, triangle).squared_distance;
}

}  // namespace deburr

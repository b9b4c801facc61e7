// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "triangle_distance.hpp"

#include <algorithm>

namespace deburr {
namespace {

NearestOnTriangle at(const Vec3& offset) { return {offset, squared_norm(offset)}; }

/// The point nearest to the origin of the segment from a to a + ab.
NearestOnTriangle nearest_on_segment(const Vec3& a, const Vec3& ab) {
  const double length = squared_norm(ab);
  const double t = length > 0 ? std::clamp(-dot(a, ab) / length, 0.0, 1.0) : 0.0;
  return at(a + t * ab);
}

}  // namespace

NearestOnTriangle nearest_on(const Vec3& p, const Triangle& triangle) {
  const Vec3 a = triangle[0] - p;
  const Vec3 ab = triangle[1] - triangle[0];
  const Vec3 ac = triangle[2] - triangle[0];

  // The nearest point of the plane is a + s ab + t ac. Taking the part along ab out first keeps t
  // good where the triangle is thin, and s is the best for the t found, whatever its error.
  const double length = squared_norm(ab);
  const double ac_along = dot(ac, ab) / length;
  const double a_along = dot(a, ab) / length;
  const Vec3 height = ac - ac_along * ab;
  const double t = -dot(a - a_along * ab, height) / squared_norm(height);
  const double s = -(a_along + t * ac_along);
  // Without area, s or t is NaN or infinite, and one of the comparisons fails.
  if (s >= 0 && t >= 0 && s + t <= 1) return at(a + s * ab + t * ac);

  return std::min({nearest_on_segment(a, ab), nearest_on_segment(a, ac),
                   nearest_on_segment(triangle[1] - p, triangle[2] - triangle[1])},
                  [](const NearestOnTriangle& x, const NearestOnTriangle& y) {
                    return x.squared_distance < y.squared_distance;
                  });
}

}  // namespace deburr

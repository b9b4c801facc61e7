// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "triangle_distance.hpp"

/// Vectors of long doubles, and another formula than the library's: inside by the signs of three
/// determinants, then the height over the plane, otherwise the nearest edge.
namespace deburr::oracle {

using Real = long double;
struct V {
  Real x, y, z;
};
inline V from(const Vec3& a) { return {a.x, a.y, a.z}; }
inline V minus(const V& a, const V& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline V plus(const V& a, Real s, const V& b) {
  return {a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}
inline Real dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline V cross(const V& a, const V& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline Real distance(const Vec3& point, const Triangle& triangle) {
  const V p = from(point);
  const V v[3] = {from(triangle[0]), from(triangle[1]), from(triangle[2])};
  const V n = cross(minus(v[1], v[0]), minus(v[2], v[0]));
  Real best = std::numeric_limits<Real>::infinity();
  Real longest = 0;
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    const V edge = minus(v[(k + 1) % 3], v[k]);
    const V to = minus(p, v[k]);
    inside = inside && dot(cross(edge, to), n) >= 0;
    const Real length = dot(edge, edge);
    longest = std::max(longest, length);
    const Real t = length > 0 ? std::clamp<Real>(dot(to, edge) / length, 0, 1) : 0;
    const V offset = plus(to, -t, edge);
    best = std::min(best, std::sqrt(dot(offset, offset)));
  }
  // Where rounding made an area out of none, the normal means nothing.
  inside = inside && dot(n, n) > 1e-24L * longest * longest;
  return inside ? std::abs(dot(minus(p, v[0]), n)) / std::sqrt(dot(n, n)) : best;
}

}  // namespace deburr::oracle

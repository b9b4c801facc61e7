// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// An axis-aligned bounding box; holds nothing at first.
struct Box {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity};
  Vec3 high{-infinity, -infinity, -infinity};

  void add(const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void add(const Box& other) {
    add(other.low);
    add(other.high);
  }
};

/// The box of points, which must be at least one.
inline Box bounding_box(Points points) {
  Box box;
  for (const Vec3& p : points) box.add(p);
  return box;
}

/// Middle and half extent of a box, without the overflow that the whole extent could have.
inline Vec3 middle(const Box& box) { return 0.5 * box.high + 0.5 * box.low; }
inline Vec3 half_extent(const Box& box) { return 0.5 * box.high - 0.5 * box.low; }

/// Squared distance from a point to a box that holds something; 0 inside.
inline double squared_distance(const Vec3& p, const Box& box) {
  const auto outside = [](double v, double low, double high) {
    return std::max({low - v, v - high, 0.0});
  };
  return squared_norm({outside(p.x, box.low.x, box.high.x), outside(p.y, box.low.y, box.high.y),
                       outside(p.z, box.low.z, box.high.z)});
}

/// Squared distance from a point to the farthest corner of a box that holds something.
inline double squared_distance_to_farthest(const Vec3& p, const Box& box) {
  const auto farther = [](double v, double low, double high) {
    return std::max(v - low, high - v);
  };
  return squared_norm({farther(p.x, box.low.x, box.high.x), farther(p.y, box.low.y, box.high.y),
                       farther(p.z, box.low.z, box.high.z)});
}

/// Bounding box of the triangles; vertices that no triangle uses do not count.
inline Box bounding_box(const TriangleMesh& mesh) {
  Box box;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) box.add(mesh.vertices[corner]);
  }
  return box;
}

}  // namespace deburr

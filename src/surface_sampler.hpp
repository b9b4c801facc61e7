// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"
#include "random.hpp"

namespace deburr {

/// A point of a mesh and the triangle that it lies in.
struct SurfacePoint {
  Vec3 position;
  std::uint32_t triangle = 0;
};

/// Draws points uniformly over the area of a mesh, or with a density that differs from triangle to
/// triangle.
class SurfaceSampler {
 public:
  /// @param mesh     has at least one triangle, whose corners are finite vertices; must outlive
  /// this
  /// @param density  of points per area, one for each triangle, only relative; empty where uniform
  explicit SurfaceSampler(const TriangleMesh& mesh, std::span<const double> density = {});

  /// Of a mesh without area, points of its last triangle.
  [[nodiscard]] SurfacePoint place(Random& random) const;
  [[nodiscard]] Vec3 draw(Random& random) const { return place(random).position; }

  /// Area of the whole mesh.
  [[nodiscard]] double area() const { return area_; }

 private:
  const TriangleMesh& mesh_;
  double area_ = 0;
  std::vector<double> sums_;  ///< of twice the weighted areas, up to and with each triangle
};

/// The unit normal of a triangle, 0 where it has no area.
[[nodiscard]] Vec3 triangle_normal(const TriangleMesh& mesh, std::uint32_t triangle);

}  // namespace deburr

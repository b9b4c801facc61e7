// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"
#include "random.hpp"

namespace deburr {

/// Draws points uniformly over the area of a mesh.
class SurfaceSampler {
 public:
  /// @param mesh  has at least one triangle, whose corners are finite vertices; must outlive this
  explicit SurfaceSampler(const TriangleMesh& mesh);

  /// Of a mesh without area, points of its last triangle.
  [[nodiscard]] Vec3 draw(Random& random) const;

  /// Area of the whole mesh.
  [[nodiscard]] double area() const { return sums_.back() / 2; }

 private:
  const TriangleMesh& mesh_;
  std::vector<double> sums_;  ///< of twice the areas, up to and with each triangle
};

}  // namespace deburr

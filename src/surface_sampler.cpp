// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_sampler.hpp"

#include <algorithm>
#include <cstddef>

namespace deburr {

SurfaceSampler::SurfaceSampler(const TriangleMesh& mesh) : mesh_(mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3& origin = mesh.vertices[a];
    sum += norm(cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin));
    sums_.push_back(sum);
  }
}

Vec3 SurfaceSampler::draw(Random& random) const {
  const auto found = std::ranges::upper_bound(sums_, random.uniform() * sums_.back());
  // Rounding can make the product the whole sum.
  const auto last = mesh_.triangles.size() - 1;
  const auto& [a, b, c] =
      mesh_.triangles[std::min(static_cast<std::size_t>(found - sums_.begin()), last)];
  double u = random.uniform();
  double v = random.uniform();
  if (u + v > 1) {  // in the other half of the parallelogram
    u = 1 - u;
    v = 1 - v;
  }
  const Vec3& origin = mesh_.vertices[a];
  return origin + u * (mesh_.vertices[b] - origin) + v * (mesh_.vertices[c] - origin);
}

}  // namespace deburr

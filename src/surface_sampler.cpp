// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_sampler.hpp"

#include <algorithm>
#include <cstddef>

namespace deburr {
namespace {

/// The normal of a triangle, as long as twice its area.
Vec3 area_normal(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const Vec3& origin = mesh.vertices[a];
  return cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin);
}

}  // namespace

SurfaceSampler::SurfaceSampler(const TriangleMesh& mesh, std::span<const double> density)
    : mesh_(mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double twice = norm(area_normal(mesh, t));
    area_ += twice / 2;
    sum += density.empty() ? twice : density[t] * twice;
    sums_.push_back(sum);
  }
}

SurfacePoint SurfaceSampler::place(Random& random) const {
  const auto found = std::ranges::upper_bound(sums_, random.uniform() * sums_.back());
  // Rounding can make the product the whole sum.
  const auto last = mesh_.triangles.size() - 1;
  const std::size_t triangle = std::min(static_cast<std::size_t>(found - sums_.begin()), last);
  const auto& [a, b, c] = mesh_.triangles[triangle];
  double u = random.uniform();
  double v = random.uniform();
  if (u + v > 1) {  // in the other half of the parallelogram
    u = 1 - u;
    v = 1 - v;
  }
  const Vec3& origin = mesh_.vertices[a];
  return {origin + u * (mesh_.vertices[b] - origin) + v * (mesh_.vertices[c] - origin),
          static_cast<std::uint32_t>(triangle)};
}

Vec3 triangle_normal(const TriangleMesh& mesh, std::uint32_t triangle) {
  const Vec3 normal = area_normal(mesh, triangle);
  const double length = norm(normal);
  if (!(length > 0)) return {};
  return {normal.x / length, normal.y / length, normal.z / length};
}

}  // namespace deburr

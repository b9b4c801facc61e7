// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"
#include "triangle_distance.hpp"

namespace deburr {

/// Unit normal of a triangle, seen from which its corners run counterclockwise; zero for a triangle
/// without area, or as thin as its coordinates are rounded, whose normal would mean nothing.
[[nodiscard]] Vec3 triangle_normal(const Triangle& triangle);

/// The corners of a triangle of a mesh.
[[nodiscard]] inline Triangle triangle_of(const TriangleMesh& mesh, std::size_t i) {
  const auto& [a, b, c] = mesh.triangles[i];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

/// Largest coordinate, without its sign: the scale of what rounding can do.
[[nodiscard]] double largest_coordinate(const Vec3& v);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "deburr/mesh.hpp"
#include "support/shapes.hpp"

// Meshes to test with.

namespace deburr {

/// Triangles of many sizes between random vertices, with some doubled and some without area.
inline TriangleMesh random_mesh(std::size_t triangles, unsigned seed) {
  Random random(seed);
  const auto point = [&] {
    const double x = random.uniform();
    const double y = random.uniform();
    return Vec3{x, y, random.uniform()};
  };
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < triangles; ++i) {
    const Vec3 a = point();
    const double size = std::pow(10, -3 * random.uniform());
    const Vec3 b = a + size * point();
    Vec3 c = a + size * point();
    if (i % 10 == 0) c = a + 0.5 * (b - a);
    if (i % 17 == 0) c = b;
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    if (i % 13 == 0) mesh.triangles.push_back({3 * i, 3 * i, 3 * i});
    if (i % 5 == 0) mesh.triangles.push_back(mesh.triangles[i / 2]);
  }
  return mesh;
}

/// The cube [0, 1]^3, seen from outside.
inline TriangleMesh cube_mesh() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                   {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// The square [0, 1]^2 in z = 0, seen from above.
inline TriangleMesh square_mesh() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

/// A closed prism over a regular polygon, of radius and height 1.
inline TriangleMesh prism_mesh(std::uint32_t sides) {
  TriangleMesh mesh;
  for (std::uint32_t k = 0; k < sides; ++k) {
    const double angle = 2 * std::numbers::pi * k / sides;
    mesh.vertices.push_back({std::cos(angle), std::sin(angle), 0});
    mesh.vertices.push_back({std::cos(angle), std::sin(angle), 1});
    const std::uint32_t a = 2 * k;
    const std::uint32_t b = 2 * ((k + 1) % sides);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
    mesh.triangles.push_back({2 * sides, b, a});
    mesh.triangles.push_back({2 * sides + 1, a + 1, b + 1});
  }
  mesh.vertices.push_back({0, 0, 0});
  mesh.vertices.push_back({0, 0, 1});
  return mesh;
}

/// The same surface with three vertices of its own for every triangle.
inline TriangleMesh with_split_vertices(const TriangleMesh& mesh) {
  TriangleMesh split;
  for (const auto& triangle : mesh.triangles) {
    const auto next = static_cast<std::uint32_t>(split.vertices.size());
    for (const std::uint32_t corner : triangle) split.vertices.push_back(mesh.vertices[corner]);
    split.triangles.push_back({next, next + 1, next + 2});
  }
  return split;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "shapes.hpp"
#include "unit_circle.hpp"

namespace deburr {
namespace {

// Fine enough for chords within 1e-5 of the diagonal of the bounding box.
constexpr int sphere_levels = 7;
constexpr std::size_t torus_steps = 512;
constexpr std::size_t cylinder_steps = 512;

constexpr double torus_radius = 1;
constexpr double tube_radius = 0.4;
constexpr double cylinder_radius = 0.5;
constexpr double cylinder_height = 1.2;

Vec3 on_unit_sphere(const Vec3& p) { return (1 / norm(p)) * p; }

TriangleMesh icosahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  TriangleMesh mesh;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-golden, golden}) {
      mesh.vertices.insert(mesh.vertices.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
    }
  }
  // Corners at distance 2 from each other, the shortest there is, make up the faces.
  const auto joined = [&](std::uint32_t i, std::uint32_t j) {
    return squared_norm(mesh.vertices[i] - mesh.vertices[j]) < 5;
  };
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t j = i + 1; j < 12; ++j) {
      for (std::uint32_t k = j + 1; k < 12; ++k) {
        if (!joined(i, j) || !joined(j, k) || !joined(k, i)) continue;
        const Vec3& a = mesh.vertices[i];
        const bool outward = dot(a, cross(mesh.vertices[j] - a, mesh.vertices[k] - a)) > 0;
        mesh.triangles.push_back({i, outward ? j : k, outward ? k : j});
      }
    }
  }
  for (Vec3& p : mesh.vertices) p = on_unit_sphere(p);
  return mesh;
}

}  // namespace

TriangleMesh cube_mesh() {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back({static_cast<double>(i & 1), static_cast<double>((i >> 1) & 1),
                             static_cast<double>((i >> 2) & 1)});
  }
  using Quad = std::array<std::uint32_t, 4>;
  for (const auto& [a, b, c, d] : {Quad{0, 4, 6, 2}, Quad{1, 3, 7, 5}, Quad{0, 1, 5, 4},
                                   Quad{2, 6, 7, 3}, Quad{0, 2, 3, 1}, Quad{4, 5, 7, 6}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh;
}

TriangleMesh sphere_mesh() {
  TriangleMesh mesh = icosahedron();
  for (int level = 0; level < sphere_levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] =
          middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new) {
        mesh.vertices.push_back(on_unit_sphere(mesh.vertices[a] + mesh.vertices[b]));
      }
      return found->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    finer.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  return mesh;
}

TriangleMesh torus_mesh() {
  const std::vector<Direction> circle = unit_circle(torus_steps);
  TriangleMesh mesh;
  add_grid(mesh, torus_steps, torus_steps, true, true, [&](std::size_t i, std::size_t j) {
    const double r = torus_radius + tube_radius * circle[j].cos;
    return Vec3{r * circle[i].cos, r * circle[i].sin, tube_radius * circle[j].sin};
  });
  return mesh;
}

TriangleMesh cylinder_mesh() {
  const std::vector<Direction> circle = unit_circle(cylinder_steps);
  TriangleMesh mesh;
  add_grid(mesh, cylinder_steps, 1, true, false, [&](std::size_t i, std::size_t j) {
    return Vec3{cylinder_radius * circle[i].cos, cylinder_radius * circle[i].sin,
                j == 0 ? 0 : cylinder_height};
  });
  const auto bottom = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), {{0, 0, 0}, {0, 0, cylinder_height}});
  for (std::uint32_t i = 0; i < cylinder_steps; ++i) {
    const std::uint32_t next = (i + 1) % static_cast<std::uint32_t>(cylinder_steps);
    mesh.triangles.push_back({bottom, 2 * next, 2 * i});
    mesh.triangles.push_back({bottom + 1, 2 * i + 1, 2 * next + 1});
  }
  return mesh;
}

}  // namespace deburr

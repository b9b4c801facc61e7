// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "deburr/synth.hpp"
#include "random.hpp"
#include "support/shapes.hpp"
#include "triangle_bvh.hpp"

namespace deburr {
namespace {

using Real = long double;

/// Distance along a ray to a triangle by Cramer's rule in higher precision, and how far inside the
/// triangle the ray passes, in barycentric coordinates: negative outside.
struct Crossing {
  Real distance, inside;
};
Crossing cross_triangle(const Vec3& o, const Vec3& d, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto det = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    return Real{p.x} * (Real{q.y} * r.z - Real{q.z} * r.y) -
           Real{p.y} * (Real{q.x} * r.z - Real{q.z} * r.x) +
           Real{p.z} * (Real{q.x} * r.y - Real{q.y} * r.x);
  };
  const Real whole = det(a - b, a - c, d);
  const Real s = det(a - o, a - c, d) / whole;
  const Real t = det(a - b, a - o, d) / whole;
  return {det(a - b, a - c, a - o) / whole, std::min({s, t, 1 - s - t})};
}

TriangleMesh random_mesh(std::size_t triangles, unsigned seed) {
  TriangleMesh mesh;
  const std::vector<Vec3> at = random_points(triangles, seed);
  const std::vector<Vec3> corners = random_points(3 * triangles, seed + 1);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    mesh.vertices.push_back(at[i / 3] + 0.2 * corners[i]);
    const auto corner = static_cast<std::uint32_t>(i);
    if (i % 3 == 0) mesh.triangles.push_back({corner, corner + 1, corner + 2});
  }
  return mesh;
}

TEST(FirstHit, EqualsASearchOverAllTriangles) {
  const TriangleMesh mesh = random_mesh(300, 1);
  const TriangleBvh bvh(mesh);
  const std::vector<Vec3> origins = random_points(3000, 3);
  const std::vector<Vec3> directions = random_directions(3000, 4);
  int met = 0;
  for (std::size_t i = 0; i < origins.size(); ++i) {
    Real first = HUGE_VALL;
    std::size_t which = 0;
    bool close = false;  // too close to an edge, or to another triangle, for rounding to decide
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& [a, b, c] = mesh.triangles[t];
      const auto [distance, inside] = cross_triangle(origins[i], directions[i], mesh.vertices[a],
                                                     mesh.vertices[b], mesh.vertices[c]);
      if (std::abs(inside) < 1e-9L && distance > 0 && distance < first) close = true;
      if (inside < 0 || distance <= 0 || distance >= first) continue;
      first = distance;
      which = t;
    }
    if (close) continue;
    const std::optional<RayHit> hit = bvh.first_hit(origins[i], directions[i]);
    ASSERT_EQ(hit.has_value(), first < HUGE_VALL) << i;
    if (!hit) continue;
    ++met;
    ASSERT_EQ(hit->triangle, which) << i;
    ASSERT_NEAR(hit->distance, static_cast<double>(first), 1e-12) << i;
    ASSERT_LT(norm(hit->point - (origins[i] + hit->distance * directions[i])), 1e-12) << i;
  }
  EXPECT_GT(met, 500);
}

// Of rays from inside a closed surface none gets out, not even along edges and through vertices.
TEST(FirstHit, LeavesNoGapBetweenTriangles) {
  for (const Shape shape : {Shape::Cube, Shape::Cylinder}) {
    const TriangleMesh mesh = shape_mesh(shape);
    const TriangleBvh bvh(mesh);
    const Vec3 inside = shape == Shape::Cube ? Vec3{0.3, 0.4, 0.5} : Vec3{0.1, 0.05, 0.6};
    for (const auto& t : mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& a = mesh.vertices[t[k]];
        const Vec3& b = mesh.vertices[t[(k + 1) % 3]];
        for (const double s : {0.0, 0.1, 1.0 / 3, 0.5, 0.7}) {
          const Vec3 direction = a + s * (b - a) - inside;
          const std::optional<RayHit> hit = bvh.first_hit(inside, direction);
          ASSERT_TRUE(hit.has_value()) << static_cast<int>(shape) << " " << s;
          ASSERT_NEAR(hit->distance, 1, 1e-12);
        }
      }
    }
  }
}

TEST(FirstHit, KnowsRaysAlongTheAxesAndThePlanesOfBoxes) {
  const TriangleMesh cube = shape_mesh(Shape::Cube);
  const TriangleBvh bvh(cube);
  for (const double sign : {-1.0, 1.0}) {
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      const Vec3 from = Vec3{0.25, 0.375, 0.625} - 3 * sign * axis;
      const std::optional<RayHit> hit = bvh.first_hit(from, sign * axis);
      ASSERT_TRUE(hit.has_value());
      EXPECT_EQ(hit->point, from + hit->distance * (sign * axis));
      EXPECT_FALSE(bvh.first_hit(from, -sign * axis).has_value());
      EXPECT_FALSE(bvh.first_hit(from + Vec3{2, 2, 2}, sign * axis).has_value());
    }
  }
  // In the plane of the face z = 1: it meets the faces that stand on it.
  const std::optional<RayHit> hit = bvh.first_hit({-1, 0.5, 1}, {1, 0, 0});
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->point, (Vec3{0, 0.5, 1}));
}

TEST(FirstHit, TakesTheFirstOfEqualTriangles) {
  TriangleMesh mesh = random_mesh(1, 5);
  for (int i = 0; i < 20; ++i) mesh.triangles.push_back(mesh.triangles[0]);
  const Vec3 centre = (1.0 / 3) * (mesh.vertices[0] + mesh.vertices[1] + mesh.vertices[2]);
  const Vec3 from{-3, 1, 2};
  const std::optional<RayHit> hit = TriangleBvh(mesh).first_hit(from, centre - from);
  ASSERT_TRUE(hit.has_value());
  EXPECT_EQ(hit->triangle, 0U);
}

}  // namespace
}  // namespace deburr

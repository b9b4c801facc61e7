// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hpp"
#include "support/triangle_oracle.hpp"
#include "triangle_bvh.hpp"
#include "triangle_normal.hpp"

namespace deburr {
namespace {

/// Places around a mesh in [0, 2]^3, at its vertices, and next to them.
std::vector<Vec3> places_for(const TriangleMesh& mesh) {
  std::vector<Vec3> places;
  for (const Vec3& p : random_points(300, 2)) {
    places.push_back(3 * p - Vec3{1, 1, 1});
    places.push_back(mesh.vertices[places.size() % mesh.vertices.size()]);
    places.push_back(places.back() + 1e-6 * p);
  }
  return places;
}

TEST(TriangleBvh, FindsTheFirstOfTheNearestTriangles) {
  for (const std::size_t triangles : {1, 3, 30, 700}) {
    const TriangleMesh mesh = random_mesh(triangles, 1);
    const TriangleBvh bvh(mesh);
    for (const Vec3& p : places_for(mesh)) {
      NearestTriangle expected{0, std::numeric_limits<double>::infinity(), {}};
      for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const double d = squared_distance(p, triangle_of(mesh, i));
        if (d < expected.squared_distance) expected = {i, d, {}};
      }
      const NearestTriangle found = bvh.nearest(p);
      ASSERT_EQ(found.triangle, expected.triangle);
      ASSERT_EQ(found.squared_distance, expected.squared_distance);
      ASSERT_EQ(found.squared_distance, bvh.squared_distance(p));
    }
  }
}

// The point is of that triangle, and as far away as the triangle is; a few roundings of 2.
TEST(TriangleBvh, GivesTheNearestPoint) {
  const TriangleMesh mesh = random_mesh(200, 3);
  const TriangleBvh bvh(mesh);
  for (const Vec3& p : places_for(mesh)) {
    const NearestTriangle found = bvh.nearest(p);
    const Triangle triangle = triangle_of(mesh, found.triangle);
    ASSERT_NEAR(static_cast<double>(oracle::distance(found.point, triangle)), 0, 2e-15);
    ASSERT_NEAR(norm(found.point - p), static_cast<double>(oracle::distance(p, triangle)), 2e-15);
  }
}

TEST(TriangleBvh, FindsAllTrianglesWithinARadius) {
  const TriangleMesh mesh = random_mesh(300, 4);
  const TriangleBvh bvh(mesh);
  std::vector<std::uint32_t> found;
  for (const Vec3& p : places_for(mesh)) {
    for (const double squared_radius : {0.0, 1e-4, 0.04}) {
      std::vector<std::uint32_t> expected;
      for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        if (squared_distance(p, triangle_of(mesh, i)) <= squared_radius) expected.push_back(i);
      }
      bvh.within(p, squared_radius, found);
      ASSERT_EQ(found, expected);
    }
  }
}

TEST(TriangleNormal, PointsToTheSideThatSeesTheCornersTurnLeft) {
  EXPECT_EQ(triangle_normal({Vec3{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}), (Vec3{0, 0, 1}));
  EXPECT_EQ(triangle_normal({Vec3{0, 0, 0}, {0, 0, 1e-200}, {0, 1e-200, 0}}), (Vec3{-1, 0, 0}));
  EXPECT_EQ(triangle_normal({Vec3{0, 5, 0}, {1e200, 5, 0}, {0, 5, 1e200}}), (Vec3{0, -1, 0}));
  // Far thinner than long, but not by rounding.
  EXPECT_EQ(triangle_normal({Vec3{0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}}), (Vec3{0, 0, 1}));
}

TEST(TriangleNormal, IsZeroWithoutAnArea) {
  EXPECT_EQ(triangle_normal({Vec3{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), Vec3{});
  EXPECT_EQ(triangle_normal({Vec3{1, 2, 3}, {4, 5, 6}, {1, 2, 3}}), Vec3{});
  EXPECT_EQ(triangle_normal({Vec3{5, 0, 0}, {5, 0, 1e-20}, {5, 1e-20, 0}}), Vec3{});
  // 0.1 + 0.2 is not 0.3: this area is one of rounding.
  EXPECT_EQ(triangle_normal({Vec3{0, 0, 0}, {0.1, 0.1, 0.3}, {0.1 + 0.2, 0.3, 0.9}}), Vec3{});
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "box.hpp"
#include "deburr/metrics.hpp"
#include "part_mesh.hpp"

namespace deburr {
namespace {

// Dimensions as in docs/synth.md, in mm.
constexpr double fillet = 8;
constexpr double hole = 10;
constexpr double boss = 12;

TEST(PartMesh, IsClosedAndConsistentlyOriented) {
  const TriangleMesh mesh = part_mesh();
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  std::set<std::uint32_t> used;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{t[k], t[(k + 1) % 3]}];
      used.insert(t[k]);
    }
  }
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << edge.first << " " << edge.second;
    ASSERT_TRUE(edges.contains({edge.second, edge.first})) << edge.first << " " << edge.second;
  }
  EXPECT_EQ(used.size(), mesh.vertices.size());
  // One piece with one hole through it: V - E + F = 0.
  EXPECT_EQ(mesh.vertices.size() + mesh.triangles.size(), edges.size() / 2);
}

TEST(PartMesh, HasNoTwoVerticesAtOnePlaceAndNoTriangleWithoutArea) {
  const TriangleMesh mesh = part_mesh();
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      ASSERT_GT(norm(mesh.vertices[i] - mesh.vertices[j]), 0.1) << i << " " << j;
    }
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    ASSERT_GT(norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a])),
              0.01);
  }
}

// The curves are polygons with their corners on the arc: n/2 r^2 sin(2 pi / n) of area, 2 n r
// sin(pi / n) of length. A triangle of the wrong side would change the volume.
TEST(PartMesh, EnclosesTheVolumeAndHasTheAreaOfTheSolid) {
  const TriangleMesh mesh = part_mesh();
  double volume = 0;
  double area = 0;
  for (const auto& [ia, ib, ic] : mesh.triangles) {
    const Vec3& a = mesh.vertices[ia];
    const Vec3& b = mesh.vertices[ib];
    const Vec3& c = mesh.vertices[ic];
    volume += dot(a, cross(b, c)) / 6;
    area += norm(cross(b - a, c - a)) / 2;
  }
  const double n = circle_points;
  const double disc = n / 2 * std::sin(2 * std::numbers::pi / n);  // of radius 1
  const double circle = 2 * n * std::sin(std::numbers::pi / n);    // of radius 1
  const double profile = 100 * 16 + 60 * 14 - 20 * 15 / 2.0 - fillet * fillet * (1 - disc / 4);
  const double exact_volume = 60 * profile - 16 * disc * hole * hole + 10 * disc * boss * boss;
  const double outline = 100 + 8 + circle * fillet / 4 + 32 + 14 + 40 + 25 + 15;
  const double exact_area =
      2 * profile + 60 * outline - 2 * disc * hole * hole + 16 * circle * hole + 10 * circle * boss;
  EXPECT_NEAR(volume, exact_volume, 1e-12 * exact_volume);
  EXPECT_NEAR(area, exact_area, 1e-12 * exact_area);
}

TEST(PartMesh, StaysNearTheCurvesThatItStandsFor) {
  const TriangleMesh mesh = part_mesh();
  std::vector<Vec3> points;
  for (int i = 0; i <= 10000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 10000;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    points.push_back({76 + hole * c, 30 + hole * s, 16.0 * i / 10000});
    points.push_back({40 + boss * c, 30 + boss * s, 30 + 10.0 * i / 10000});
    if (c >= 0 && s >= 0) points.push_back({92 + fillet * c, 20, 8 + fillet * s});
  }
  const SurfaceError error = compare_to_surface(points, mesh);
  EXPECT_EQ(error.diagonal, std::sqrt(100.0 * 100 + 60 * 60 + 40 * 40));
  EXPECT_LT(error.maximum, 1e-5 * error.diagonal);
  EXPECT_GT(error.maximum, 0);
}

TEST(PartMesh, FillsItsBoundingBox) {
  const Box box = bounding_box(part_mesh());
  EXPECT_EQ(box.low, (Vec3{0, 0, 0}));
  EXPECT_EQ(box.high, (Vec3{100, 60, 40}));
}

}  // namespace
}  // namespace deburr

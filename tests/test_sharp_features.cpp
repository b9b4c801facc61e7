// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "deburr/sharp_features.hpp"
#include "part_mesh.hpp"
#include "support/compare.hpp"
#include "support/meshes.hpp"

namespace deburr {
namespace {

double total_length(const SharpFeatures& sharp) {
  double sum = 0;
  for (const auto& [a, b] : sharp.edges) sum += norm(b - a);
  return sum;
}

void expect_cube(const SharpFeatures& sharp) {
  ASSERT_EQ(sharp.edges.size(), 12U);
  for (const auto& [a, b] : sharp.edges) EXPECT_EQ(norm(b - a), 1);  // no diagonal
  std::vector<Vec3> corners = sharp.corners;
  std::ranges::sort(corners, {}, [](const Vec3& v) { return std::tie(v.z, v.y, v.x); });
  EXPECT_EQ(corners, cube_mesh().vertices);
}

/// Two squares that meet at the y axis, the second one bent up by this angle.
TriangleMesh fold(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  const Vec3 out{std::cos(angle), 0, std::sin(angle)};
  return {{{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, out, out + Vec3{0, 1, 0}},
          {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}};
}

/// A flat sector of this angle, with a bowl in place of the rest of the disc: sharp along both
/// sides of the sector alone.
TriangleMesh bowl(double sector) {
  constexpr std::uint32_t steps = 60;
  TriangleMesh mesh{{{0, 0, 0}}, {}};
  for (std::uint32_t k = 0; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    const double angle = (sector + part * (360 - sector)) * std::numbers::pi / 180;
    mesh.vertices.push_back({std::cos(angle), std::sin(angle), -std::sin(part * std::numbers::pi)});
    if (k > 0) mesh.triangles.push_back({0, k, k + 1});
  }
  mesh.triangles.push_back({0, steps + 1, 1});
  return mesh;
}

TEST(SharpFeatures, OfACubeAreItsEdgesAndCorners) {
  expect_cube(find_sharp_features(cube_mesh()));
  expect_cube(find_sharp_features(with_split_vertices(cube_mesh())));
}

TEST(SharpFeatures, DoNotDependOnTheDirectionOfTriangles) {
  for (unsigned which = 1; which < 4096; which += 97) {
    TriangleMesh mesh = cube_mesh();
    for (std::size_t i = 0; i < 12; ++i) {
      if ((which >> i) % 2 == 1) std::swap(mesh.triangles[i][0], mesh.triangles[i][1]);
    }
    expect_cube(find_sharp_features(mesh));
  }
}

TEST(SharpFeatures, IgnoreDoubledTrianglesAndThoseWithoutArea) {
  TriangleMesh mesh = cube_mesh();
  mesh.triangles.push_back({0, 2, 3});
  mesh.triangles.push_back({3, 2, 0});  // seen from inside
  mesh.triangles.push_back({5, 5, 6});
  mesh.vertices.push_back({0.5, 0, 0});
  mesh.triangles.push_back({0, 8, 1});            // along an edge
  mesh.vertices.push_back({std::nan(""), 0, 0});  // in no triangle
  expect_cube(find_sharp_features(mesh));
}

TEST(SharpFeatures, TakeZeroOfEitherSignAsOnePlace) {
  TriangleMesh mesh = with_split_vertices(cube_mesh());
  for (std::size_t i = 0; i < mesh.vertices.size(); i += 2) {
    Vec3& v = mesh.vertices[i];
    if (v.x == 0) v.x = -0.0;
    if (v.z == 0) v.z = -0.0;
  }
  const SharpFeatures sharp = find_sharp_features(mesh);
  EXPECT_EQ(sharp.edges.size(), 12U);
  EXPECT_EQ(sharp.corners.size(), 8U);
}

TEST(SharpFeatures, BeginAboveTheSharpAngle) {
  for (const double degrees : {0.0, 10.0, 29.9, 30.0, -29.9, -30.0}) {
    EXPECT_TRUE(find_sharp_features(fold(degrees)).edges.empty()) << degrees;
  }
  for (const double degrees : {30.1, 90.0, 150.0, 179.0, -30.1, -90.0}) {
    const SharpFeatures sharp = find_sharp_features(fold(degrees));
    ASSERT_EQ(sharp.edges.size(), 1U) << degrees;
    EXPECT_EQ(total_length(sharp), 1);
    EXPECT_TRUE(sharp.corners.empty());  // it ends at the border, which is not sharp
  }
}

// Three sheets along one line: sharp if two of them are, seen from the same side.
TEST(SharpFeatures, TakeEdgesOfMoreThanTwoTriangles) {
  TriangleMesh mesh = fold(10);
  mesh.vertices.push_back({0, 0.5, 1});
  mesh.triangles.push_back({1, 2, 6});
  EXPECT_EQ(find_sharp_features(mesh).edges.size(), 1U);
}

TEST(SharpFeatures, OfPrismsFollowTheAngleOfTheirSides) {
  for (const std::uint32_t sides : {3U, 4U, 8U, 11U}) {  // 11 turn by 32.7 degrees
    const SharpFeatures sharp = find_sharp_features(prism_mesh(sides));
    EXPECT_EQ(sharp.edges.size(), 3 * sides);
    EXPECT_EQ(sharp.corners.size(), 2 * sides);
  }
  for (const std::uint32_t sides : {12U, 13U, 64U}) {  // 12 turn by 30, 13 by 27.7 degrees
    const SharpFeatures sharp = find_sharp_features(prism_mesh(sides));
    EXPECT_EQ(sharp.edges.size(), 2 * sides);  // the rims
    EXPECT_TRUE(sharp.corners.empty());
    EXPECT_NEAR(total_length(sharp), 4 * sides * std::sin(std::numbers::pi / sides), 1e-12);
  }
}

TEST(SharpFeatures, HaveACornerWhereTwoEdgesTurn) {
  for (const auto& [sector, corners] :
       {std::pair{120.0, 1U}, {145.0, 1U}, {155.0, 0U}, {175.0, 0U}}) {
    const SharpFeatures sharp = find_sharp_features(bowl(sector));
    EXPECT_EQ(sharp.edges.size(), 2U) << sector;
    ASSERT_EQ(sharp.corners.size(), corners) << sector;
    for (const Vec3& corner : sharp.corners) EXPECT_EQ(corner, Vec3{});
  }
}

// Front and back outline, the rims of the hole and the foot and top of the boss, and six edges
// along y: the fillet has none. Dimensions as in docs/synth.md.
TEST(SharpFeatures, OfThePartAreThoseOfItsDrawing) {
  const SharpFeatures sharp = find_sharp_features(part_mesh());
  EXPECT_EQ(sharp.corners.size(), 12U);
  const double n = circle_points;
  const double circle = 2 * n * std::sin(std::numbers::pi / n);  // of radius 1
  const double outline = 100 + 8 + circle * 8 / 4 + 32 + 14 + 40 + 25 + 15;
  const double expected = 2 * outline + 2 * circle * 10 + 2 * circle * 12 + 6 * 60;
  EXPECT_NEAR(total_length(sharp), expected, 1e-12 * expected);
}

TEST(SharpFeatures, FollowMotionsAndScale) {
  for (const double scale : {1e-6, 1.0, 1e6}) {
    TriangleMesh mesh = part_mesh();
    mesh.vertices = mapped(mesh.vertices, [&](const Vec3& v) {
      return scale * (random_rotation(4)(v) + Vec3{1e6, -1e6, 4e5});
    });
    const SharpFeatures sharp = find_sharp_features(mesh);
    EXPECT_EQ(sharp.edges.size(), find_sharp_features(part_mesh()).edges.size()) << scale;
    EXPECT_EQ(sharp.corners.size(), 12U) << scale;
  }
}

TEST(SharpFeatures, RefuseMeshesThatAreNone) {
  EXPECT_EQ(invalid_argument_of([] { (void)find_sharp_features({}); }), "surface has no triangles");
}

}  // namespace
}  // namespace deburr

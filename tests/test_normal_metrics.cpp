// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "deburr/normal_metrics.hpp"
#include "support/compare.hpp"
#include "support/meshes.hpp"
#include "triangle_normal.hpp"

namespace deburr {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

NormalError of_one(const Vec3& p, const Vec3& n, const TriangleMesh& surface) {
  return normal_error(std::vector{p}, std::vector{n}, surface);
}

Vec3 tilted(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::sin(angle), 0, std::cos(angle)};
}

TEST(NormalError, IsTheAngleToTheNearestFaceOfACube) {
  const Vec3 over_the_top{0.3, 0.4, 1.2};
  for (const double degrees : {0.0, 1e-6, 10.0, 60.0, 90.0, 170.0, 180.0}) {
    // The length of a normal is of no matter.
    for (const double length : {1.0, 1e-200, 1e200}) {
      const NormalError error = of_one(over_the_top, length * tilted(degrees), cube_mesh());
      EXPECT_NEAR(error.oriented, degrees, 1e-13) << degrees;
      EXPECT_NEAR(error.unoriented, std::min(degrees, 180 - degrees), 1e-13) << degrees;
      EXPECT_EQ(error.count, 1U);
    }
  }
}

TEST(NormalError, TakesTheMeanOverWhatHasANormal) {
  const std::vector<Vec3> points{
      {0.5, 0.5, 1}, {0.5, 0.5, 0}, {0.5, 0.5, 1}, {nan, 0, 0}, {0.5, 0.5, 1}};
  const std::vector<Vec3> normals{tilted(20), tilted(40), {0, 0, 0}, tilted(60), {0, nan, 1}};
  const NormalError error = normal_error(points, normals, cube_mesh());
  EXPECT_EQ(error.count, 2U);
  EXPECT_NEAR(error.unoriented, 30, 1e-12);  // 20 and 40
  EXPECT_NEAR(error.oriented, 80, 1e-12);    // 20 and 140: the bottom looks down
  EXPECT_EQ(normal_error({}, {}, cube_mesh()).count, 0U);
}

// At an edge or a corner, any of the faces there will do.
TEST(NormalError, TakesTheBestOfTheTrianglesAtTheSameDistance) {
  const std::vector<Vec3> faces{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const TriangleMesh& mesh : {cube_mesh(), with_split_vertices(cube_mesh())}) {
    for (const Vec3& p : {Vec3{1, 1, 1}, {1.5, 1.25, 1.75}, {1 + 1e-12, 1 + 1e-12, 1 + 1e-12}}) {
      for (const Vec3& n : faces) EXPECT_EQ(of_one(p, n, mesh).oriented, 0);
    }
    const Vec3 at_edge{1, 0.3, 1};
    EXPECT_EQ(of_one(at_edge, {1, 0, 0}, mesh).oriented, 0);
    EXPECT_EQ(of_one(at_edge, {0, 0, 1}, mesh).oriented, 0);
    EXPECT_EQ(of_one(at_edge, {0, 1, 0}, mesh).oriented, 90);
    EXPECT_NEAR(of_one(at_edge, {1, 0, 1}, mesh).oriented, 45, 1e-13);
    // The signs are judged apart: unoriented this is right, oriented the other face is better.
    EXPECT_EQ(of_one(at_edge, {-1, 0, 0}, mesh).unoriented, 0);
    EXPECT_EQ(of_one(at_edge, {-1, 0, 0}, mesh).oriented, 90);
    // Nearer to the top by far more than rounding.
    EXPECT_EQ(of_one({1 - 1e-9, 0.3, 1}, {1, 0, 0}, mesh).oriented, 90);
  }
}

TEST(NormalError, TakesPlacesRoundedAtLargeOffsetsAsTheSame) {
  TriangleMesh mesh = cube_mesh();
  const Vec3 offset{1e7, -1e7, 4e6};
  for (Vec3& v : mesh.vertices) v = 0.1 * v + offset;
  const Vec3 corner = mesh.vertices[7] - Vec3{2e-9, 0, 0};  // one rounding away
  for (const Vec3& n : {Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
    EXPECT_NEAR(of_one(corner, n, mesh).oriented, 0, 1e-5);
  }
}

TEST(NormalError, LeavesOutTrianglesWithoutArea) {
  TriangleMesh mesh = square_mesh();
  mesh.vertices.push_back({5, 5, 5});
  mesh.triangles.push_back({0, 1, 1});  // on the border
  mesh.triangles.push_back({4, 4, 4});
  EXPECT_EQ(of_one({0.5, 0, 0}, {0, 0, 1}, mesh).oriented, 0);
  EXPECT_EQ(of_one({6, 6, 6}, {0, 0, 1}, mesh).count, 0U);
}

TEST(NormalError, EqualsBruteForceOnRandomMeshes) {
  TriangleMesh mesh = random_mesh(200, 1);
  // Copies of others are skipped, so that the nearest is one triangle.
  const std::vector<Vec3> points = random_points(300, 2);
  const std::vector<Vec3> normals = random_directions(300, 3);
  double unoriented = 0;
  double oriented = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t best = 0;
    for (std::size_t t = 1; t < mesh.triangles.size(); ++t) {
      if (squared_distance(points[i], triangle_of(mesh, t)) <
          squared_distance(points[i], triangle_of(mesh, best))) {
        best = t;
      }
    }
    const auto [a, b, c] = triangle_of(mesh, best);
    const Vec3 n = cross(b - a, c - a);
    if (norm(n) < 1e-12 * norm(b - a) * norm(c - a)) continue;
    ++count;
    oriented += angle(normals[i], n);
    unoriented += std::min(angle(normals[i], n), 180 - angle(normals[i], n));
  }
  const NormalError one = normal_error(points, normals, mesh, {.threads = 1});
  EXPECT_EQ(one.count, count);
  EXPECT_NEAR(one.oriented, oriented / static_cast<double>(count), 1e-9);
  EXPECT_NEAR(one.unoriented, unoriented / static_cast<double>(count), 1e-9);
  const NormalError three = normal_error(points, normals, mesh, {.threads = 3});
  EXPECT_EQ(three.oriented, one.oriented);
}

TEST(NormalError, AgainstACloudTakesTheNearestPointThatHasANormal) {
  const std::vector<Vec3> truth{{0, 0, 0}, {1, 0, 0},   {1, 0, 0},
                                {2, 0, 0}, {nan, 0, 0}, {0.1, 0, 0}};
  const std::vector<Vec3> normals{{0, 0, 1}, {0, 2, 0}, {1, 0, 0},
                                  {0, 0, 0}, {0, 0, 1}, {nan, 0, 1}};
  const auto error = [&](const Vec3& p, const Vec3& n) {
    return normal_error(std::vector{p}, std::vector{n}, truth, normals);
  };
  EXPECT_NEAR(error({0.2, 0, 0}, tilted(10)).oriented, 10, 1e-13);
  EXPECT_NEAR(error({0.2, 0, 0}, tilted(170)).oriented, 170, 1e-13);
  EXPECT_NEAR(error({0.2, 0, 0}, tilted(170)).unoriented, 10, 1e-13);
  // Two points at one place; and the one at 2 has no normal.
  EXPECT_EQ(error({1.9, 0, 0}, {1, 0, 0}).oriented, 0);
  EXPECT_EQ(error({1.9, 0, 0}, {0, 1, 0}).oriented, 0);
  EXPECT_EQ(error({1.9, 0, 0}, {0, 0, 1}).oriented, 90);
  EXPECT_EQ(normal_error(truth, normals, Points{}, Normals{}).count, 0U);
}

TEST(NormalError, RefusesSizesThatDiffer) {
  const std::vector<Vec3> one{{0, 0, 1}};
  EXPECT_EQ(invalid_argument_of([&] { (void)normal_error(one, {}, cube_mesh()); }),
            "normals must have one entry per point (1), got 0");
  EXPECT_EQ(invalid_argument_of([&] { (void)normal_error(one, one, one, Normals{}); }),
            "true_normals must have one entry per point (1), got 0");
  EXPECT_EQ(invalid_argument_of([&] { (void)normal_error(one, one, TriangleMesh{}); }),
            "surface has no triangles");
}

}  // namespace
}  // namespace deburr

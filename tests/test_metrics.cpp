// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>

#include "deburr/error.hpp"
#include "deburr/metrics.hpp"
#include "support/meshes.hpp"
#include "support/triangle_oracle.hpp"
#include "triangle_distance.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

class Uniform {
 public:
  explicit Uniform(unsigned seed) : random_(seed) {}
  double operator()() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  int integer(int low, int high) { return low + static_cast<int>((high - low + 1) * (*this)()); }
  Vec3 point() {
    const double x = (*this)();
    const double y = (*this)();
    const double z = (*this)();
    return {x, y, z};
  }

 private:
  std::mt19937_64 random_;
};

double brute_force(const Vec3& p, const TriangleMesh& mesh) {
  oracle::Real best = std::numeric_limits<oracle::Real>::infinity();
  for (const auto& [a, b, c] : mesh.triangles) {
    best =
        std::min(best, oracle::distance(p, {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}));
  }
  return static_cast<double>(best);
}

TEST(DistanceToSurface, EqualsBruteForceOnRandomMeshes) {
  for (const std::size_t triangles : {1, 2, 4, 5, 30, 700}) {
    const TriangleMesh mesh = random_mesh(triangles, 1);
    Uniform uniform(2);
    std::vector<Vec3> points;
    for (int i = 0; i < 400; ++i) {
      points.push_back(3 * uniform.point() - Vec3{1, 1, 1});
      points.push_back(mesh.vertices[i % mesh.vertices.size()]);
      points.push_back(points.back() + 1e-6 * uniform.point());
    }
    const std::vector<double> distances = distance_to_surface(points, mesh);
    ASSERT_EQ(distances.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      // A few roundings of coordinates up to 2.
      ASSERT_NEAR(distances[i], brute_force(points[i], mesh), 2e-15) << "point " << i;
    }
  }
}

// In the basis e1, e2, n of integers, orthogonal and of length 3 each, a triangle in a slanted
// plane and a point over it are exact doubles, and the distance splits into one within the plane
// and one across it, however thin the triangle is.
TEST(TriangleDistance, IsExactForNeedles) {
  const Vec3 e1{1, 2, 2};
  const Vec3 e2{2, 1, -2};
  const Vec3 n{2, -2, 1};
  Uniform uniform(3);
  const int length = 1000000000;
  for (int i = 0; i < 20000; ++i) {
    const int height = i % 4;  // relative to the length 1e-9, and none at all
    const auto corner = [&] {
      return Vec3{1.0 * uniform.integer(0, length), 1.0 * uniform.integer(0, height), 0};
    };
    const Triangle flat{corner(), corner(), corner()};
    const Vec3 at{1.0 * uniform.integer(-length / 4, length + length / 4),
                  1.0 * uniform.integer(-2, 2 + height), 0};
    const double across = i % 3 == 0 ? 0 : uniform.integer(0, length);
    const auto raised = [&](const Vec3& p, double w) { return p.x * e1 + p.y * e2 + w * n; };
    const double found = std::sqrt(squared_distance(
        raised(at, across), {raised(flat[0], 0), raised(flat[1], 0), raised(flat[2], 0)}));
    const auto within = static_cast<double>(oracle::distance(at, flat));
    ASSERT_NEAR(found, 3 * std::hypot(within, across), 4e-15 * length) << "triangle " << i;
  }
}

TEST(TriangleDistance, TakesTrianglesWithoutAreaAsSegmentsAndPoints) {
  const auto distance = [](const Vec3& p, const Triangle& triangle) {
    return std::sqrt(squared_distance(p, triangle));
  };
  const Vec3 a{1, 1, 1};
  EXPECT_EQ(distance({1, 4, 5}, {a, a, a}), 5);
  EXPECT_EQ(distance(a, {a, a, a}), 0);
  const Vec3 b{5, 1, 1};
  const Vec3 m{3, 1, 1};
  const Vec3 beside{2, 4, 5};
  const Vec3 beyond{8, 5, 1};
  for (const Triangle& t :
       {Triangle{a, a, b}, {a, b, a}, {b, a, a}, {a, b, m}, {a, m, b}, {m, a, b}, {m, b, a}}) {
    EXPECT_EQ(distance(beside, t), 5);
    EXPECT_EQ(distance(beyond, t), 5);
    EXPECT_EQ(distance(m, t), 0);
  }
}

TEST(DistanceToSurface, IsThatDerivedByHandOnACube) {
  const std::vector<Vec3> points{
      {0.5, 0.5, 0.5},    // the centre: to any face
      {0.5, 0.25, 0.5},   // inside, to y = 0
      {0.5, 0.5, 1.75},   // over a face
      {1.0, 0.3, 0.7},    // on a face
      {1.3, 1.4, 0.5},    // beyond an edge: 3-4-5
      {-0.3, 0.6, -0.4},  // beyond another
      {2, 3, 3},          // beyond a corner: 1, 2, 2
      {-2, -3, -6},       // beyond the opposite corner: 2, 3, 6
      {1, 1, 1},          // on a corner
  };
  const std::vector<double> d = distance_to_surface(points, cube_mesh());
  const std::vector<double> expected{0.5, 0.25, 0.75, 0, 0.5, 0.5, 3, 7, 0};
  ASSERT_EQ(d.size(), expected.size());
  for (std::size_t i = 0; i < d.size(); ++i) EXPECT_NEAR(d[i], expected[i], 1e-15) << i;
}

TEST(DistanceToSurface, FollowsRigidMotionsAndScale) {
  TriangleMesh mesh = random_mesh(200, 4);
  Uniform uniform(5);
  std::vector<Vec3> points(500);
  for (Vec3& p : points) p = 2 * uniform.point();
  const std::vector<double> before = distance_to_surface(points, mesh);
  // The rotation has the rows (1, 2, 2) / 3, (2, 1, -2) / 3, (2, -2, 1) / 3, up to a reflection.
  const auto move = [](Vec3& p) {
    p = Vec3{(p.x + 2 * p.y + 2 * p.z) / 3, (2 * p.x + p.y - 2 * p.z) / 3,
             (2 * p.x - 2 * p.y + p.z) / 3} +
        Vec3{0.5, -2, 1};
    p = 1e-9 * p;
  };
  for (Vec3& p : points) move(p);
  for (Vec3& p : mesh.vertices) move(p);
  const std::vector<double> after = distance_to_surface(points, mesh);
  for (std::size_t i = 0; i < points.size(); ++i) ASSERT_NEAR(after[i], 1e-9 * before[i], 1e-23);
}

// Multiples of 2^-20 stay exact when shifted by 1e7, so not one bit may change.
TEST(DistanceToSurface, LosesNothingAtLargeOffsets) {
  TriangleMesh mesh = random_mesh(300, 6);
  Uniform uniform(7);
  std::vector<Vec3> points(500);
  for (Vec3& p : points) p = 2 * uniform.point();
  const auto round = [](Vec3& p) {
    p = 0x1p-20 *
        Vec3{std::round(0x1p20 * p.x), std::round(0x1p20 * p.y), std::round(0x1p20 * p.z)};
  };
  for (Vec3& p : mesh.vertices) round(p);
  for (Vec3& p : points) round(p);
  const std::vector<double> before = distance_to_surface(points, mesh);
  const Vec3 offset{1e7, -1e7, 4e6};
  for (Vec3& p : mesh.vertices) p += offset;
  for (Vec3& p : points) p += offset;
  EXPECT_EQ(distance_to_surface(points, mesh), before);
}

TEST(DistanceToSurface, IsTheSameForAnyNumberOfThreads) {
  const TriangleMesh mesh = random_mesh(300, 8);
  Uniform uniform(9);
  std::vector<Vec3> points(5000);
  for (Vec3& p : points) p = uniform.point();
  const std::vector<double> one = distance_to_surface(points, mesh, {.threads = 1});
  for (const int threads : {2, 3, 7}) {
    EXPECT_EQ(distance_to_surface(points, mesh, {.threads = threads}), one);
  }
}

TEST(DistanceToSurface, GivesNanWhereAPointIsNotFinite) {
  const std::vector<Vec3> points{{nan, 0, 0}, {0.5, 0.5, 2}, {0, infinity, 0}, {0, 0, -infinity}};
  EXPECT_THAT(distance_to_surface(points, cube_mesh()),
              ElementsAre(testing::IsNan(), 1, testing::IsNan(), testing::IsNan()));
}

TEST(DistanceToSurface, RefusesMeshesThatAreNone) {
  const auto message = [](const TriangleMesh& mesh) -> std::string {
    try {
      (void)compare_to_surface({}, mesh);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message({}), "surface has no triangles");
  EXPECT_EQ(message({{{0, 0, 0}}, {}}), "surface has no triangles");
  EXPECT_EQ(message({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}, {0, 1, 2}}}),
            "surface.triangles[1] has corner 2 of 2 vertices");
  EXPECT_EQ(message({{{0, 0, 0}, {1, nan, 0}}, {{0, 1, 1}}}), "surface.vertices[1] is not finite");
  // A vertex that no triangle uses is no part of the surface.
  EXPECT_EQ(message({{{0, 0, 0}, {1, nan, 0}}, {{0, 0, 0}}}), "");
}

TEST(DistanceToSurface, StopsWhenCancelled) {
  const std::vector<Vec3> points(10);
  const Execution execution{.cancelled = [] { return true; }};
  EXPECT_THROW((void)distance_to_surface(points, cube_mesh(), execution), Cancelled);
}

TEST(CompareToSurface, SummarisesFinitePoints) {
  TriangleMesh mesh = cube_mesh();
  mesh.vertices.push_back({9, 9, 9});  // in no triangle
  const std::vector<Vec3> points{{0.5, 0.5, 4}, {nan, 0, 0}, {-4, 0.5, 0.5}, {0.5, infinity, 0}};
  const SurfaceError error = compare_to_surface(points, mesh);
  EXPECT_EQ(error.count, 2U);
  EXPECT_EQ(error.mean, 3.5);
  EXPECT_EQ(error.rms, std::sqrt(12.5));
  EXPECT_EQ(error.percentile_95, 4);
  EXPECT_EQ(error.maximum, 4);
  EXPECT_EQ(error.diagonal, std::sqrt(3.0));
}

// Distances 1 to n in any order: at least 95 % of them are no larger than the percentile, fewer
// than that are smaller.
TEST(CompareToSurface, TakesThePercentileByRank) {
  for (const auto& [n, expected] : {std::pair{1, 1}, {2, 2}, {19, 19}, {20, 19}, {100, 95}}) {
    std::vector<Vec3> points;
    for (const std::uint32_t i : random_permutation(static_cast<std::size_t>(n), 3)) {
      points.push_back({0.5, 0.5, 2.0 + i});
    }
    EXPECT_EQ(compare_to_surface(points, cube_mesh()).percentile_95, expected) << n;
  }
}

TEST(CompareToSurface, IsZeroWithoutFinitePoints) {
  const std::vector<Vec3> points{{nan, 0, 0}};
  for (const Points given : {Points{}, Points{points}}) {
    const SurfaceError error = compare_to_surface(given, cube_mesh());
    EXPECT_EQ(error.count, 0U);
    EXPECT_EQ(error.mean, 0);
    EXPECT_EQ(error.rms, 0);
    EXPECT_EQ(error.percentile_95, 0);
    EXPECT_EQ(error.maximum, 0);
    EXPECT_EQ(error.diagonal, std::sqrt(3.0));
  }
}

}  // namespace
}  // namespace deburr

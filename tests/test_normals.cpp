// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "deburr/error.hpp"
#include "deburr/normals.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"
#include "support/stage_oracle.hpp"

namespace deburr {
namespace {

using testing::Each;
using testing::StartsWith;

/// Neighbourhoods in which the points after the first are the neighbours of the first.
Neighborhoods star(std::size_t n) {
  std::vector<std::size_t> offsets(n + 1, n - 1);
  offsets[0] = 0;
  std::vector<std::uint32_t> indices(n - 1);
  for (std::uint32_t k = 0; k + 1 < n; ++k) indices[k] = k + 1;
  return {offsets, indices};
}

Vec3 normal_of_first(const std::vector<Vec3>& points) {
  return estimate_normals(points, star(points.size()))[0];
}

double max_angle(Normals a, Normals b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::min(angle(a[i], b[i]), angle(a[i], -b[i])));
  }
  return largest;
}

TEST(EstimateNormals, IsExactOnAPlane) {
  const Sampled plane = plane_grid(12);
  const Rotation turn = random_rotation(1);
  const std::vector<Vec3> points = mapped(plane.points, turn);
  const std::vector<Vec3> normals =
      estimate_normals(points, find_neighbors(points, {.max_count = 12}));
  EXPECT_LE(max_difference_of_lines(normals, mapped(plane.normals, turn)), 1e-13);
}

TEST(EstimateNormals, EqualsTheOracle) {
  const std::vector<Vec3> points = random_points(400, 2);
  const Neighborhoods near = find_neighbors(points, {.max_count = 12});
  const std::vector<Vec3> normals = estimate_normals(points, near);
  std::vector<Vec3> expected;
  for (std::size_t i = 0; i < points.size(); ++i) {
    expected.push_back(oracle::pca_normal(points, near[i]));
  }
  EXPECT_LE(max_difference_of_lines(normals, expected), 1e-9);
}

TEST(EstimateNormals, FollowsASphere) {
  const Sampled truth = sphere(5000, 3);
  const std::vector<Vec3> normals =
      estimate_normals(truth.points, find_neighbors(truth.points, {.max_count = 20}));
  EXPECT_LT(max_angle(normals, truth.normals), 4);
}

// A nanometre in ten kilometres is below the last bit; a millimetre is not.
TEST(EstimateNormals, HoldsFarFromTheOrigin) {
  const Sampled plane = plane_grid(12);
  const Rotation turn = random_rotation(4);
  const std::vector<Vec3> points = mapped(plane.points, [&](const Vec3& p) {
    return Vec3{1e7, -1e7, 1e7} + 1e-3 * turn(p);
  });
  const std::vector<Vec3> normals =
      estimate_normals(points, find_neighbors(points, {.max_count = 12}));
  EXPECT_LT(max_angle(normals, mapped(plane.normals, turn)), 1e-4);
}

TEST(EstimateNormals, LeavesThePointItselfOut) {
  const Vec3 n = normal_of_first({{0, 0, 5}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}});
  EXPECT_LE(norm(n - Vec3{0, 0, n.z}), 1e-15);
}

TEST(EstimateNormals, AreZeroWithoutAPlane) {
  EXPECT_EQ(normal_of_first({{0, 0, 0}}), Vec3{});
  EXPECT_EQ(normal_of_first({{0, 0, 0}, {1, 0, 0}}), Vec3{});
  EXPECT_EQ(normal_of_first({{0, 0, 0}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}), Vec3{});
  const std::vector<Vec3> equal(20, Vec3{0.1, 0.2, 0.3});
  EXPECT_THAT(estimate_normals(equal, find_neighbors(equal, {.max_count = 5})), Each(Vec3{}));
}

TEST(EstimateNormals, LieAcrossALine) {
  const Vec3 along = random_directions(1, 5)[0];
  const Vec3 n = normal_of_first({{}, 1 * along, 2 * along, 3 * along, 7 * along});
  EXPECT_NEAR(norm(n), 1, 1e-14);
  EXPECT_NEAR(dot(n, along), 0, 1e-14);
}

TEST(EstimateNormals, RefusesNeighbourhoodsOfOtherPoints) {
  EXPECT_EQ(invalid_argument_of([] { (void)estimate_normals(random_points(3, 1), star(2)); }),
            "neighborhoods must have one entry per point (3), got 2");
}

TEST(EstimateNormals, StopsWhenCancelled) {
  const std::vector<Vec3> points = random_points(50, 6);
  const Neighborhoods near = find_neighbors(points, {.max_count = 5});
  EXPECT_THROW((void)estimate_normals(points, near, {.cancelled = [] { return true; }}), Cancelled);
}

TEST(RefitNormals, EqualsTheOracle) {
  const std::vector<Vec3> points = random_points(400, 7);
  const std::vector<Vec3> normals = tilted(std::vector<Vec3>(400, {0, 0, 1}), 0.8, 8);
  const Neighborhoods near = find_neighbors(points, {.radius = 0.2});
  for (const double blend : {0.3, 1.0}) {
    const NormalRefitOptions options{.position_scale = 0.1, .normal_scale = 0.7, .blend = blend};
    std::vector<Vec3> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      expected.push_back(oracle::refitted_normal(points, normals, i, near[i], options));
    }
    EXPECT_LE(max_difference(refit_normals(points, normals, near, options), expected), 1e-9);
  }
}

TEST(RefitNormals, WithoutBlendIsTheIdentity) {
  const Sampled noisy = sphere(500, 9);
  const std::vector<Vec3> normals = tilted(noisy.normals, 0.3, 10);
  const Neighborhoods near = find_neighbors(noisy.points, {.max_count = 12});
  const std::vector<Vec3> same =
      refit_normals(noisy.points, normals, near, {.position_scale = 0.2, .blend = 0});
  EXPECT_LE(max_difference(same, normals), 1e-15);
}

TEST(RefitNormals, StaysOnTheSideOfTheOldNormal) {
  const Sampled truth = sphere(500, 11);
  const Neighborhoods near = find_neighbors(truth.points, {.max_count = 12});
  const NormalRefitOptions options{.position_scale = 0.2, .blend = 1};
  const std::vector<Vec3> outward = refit_normals(truth.points, truth.normals, near, options);
  const std::vector<Vec3> inward = refit_normals(
      truth.points, mapped(truth.normals, [](const Vec3& n) { return -n; }), near, options);
  for (std::size_t i = 0; i < outward.size(); ++i) {
    ASSERT_GT(dot(outward[i], truth.normals[i]), 0.9);
    ASSERT_EQ(inward[i], -outward[i]);
  }
}

TEST(RefitNormals, StopsAtTheEdgesOfACube) {
  const Sampled truth = cube_grid(16);
  const std::vector<Vec3> points = with_noise(truth.points, 0.01, 12);
  const Neighborhoods near = find_neighbors(points, {.max_count = 30});
  std::vector<Vec3> normals = estimate_normals(points, near);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (dot(normals[i], truth.normals[i]) < 0) normals[i] = -normals[i];
  }
  const auto error = [&] {
    return mean_of(points.size(),
                   [&](std::size_t i) { return angle(normals[i], truth.normals[i]); });
  };
  const double before = error();
  for (int round = 0; round < 5; ++round) {
    normals = refit_normals(points, normals, near, {.position_scale = 0.2});
  }
  EXPECT_LT(error(), 0.6 * before);
}

TEST(RefitNormals, KeepsWhatCannotBeFitted) {
  const NormalRefitOptions options{.position_scale = 1, .blend = 1};
  // A second point alone, then a third on the other side: no third point in the fit.
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 1}, {0, 1, 1}};
  const Vec3 n{0.6, 0, 0.8};
  EXPECT_EQ(refit_normals(points, std::vector<Vec3>{n, n, -n}, star(3), options)[0], n);
  EXPECT_NE(refit_normals(points, std::vector<Vec3>{n, n, n}, star(3), options)[0], n);
  EXPECT_EQ(refit_normals(points, std::vector<Vec3>{{}, n, n}, star(3), options)[0], Vec3{});
  EXPECT_EQ(refit_normals(points, std::vector<Vec3>{n, {}, {}}, star(3), options)[0], n);
  const std::vector<Vec3> equal(3);
  EXPECT_EQ(refit_normals(equal, std::vector<Vec3>(3, n), star(3), options)[0], n);
}

TEST(RefitNormals, NamesTheWrongOption) {
  const auto error = [](const NormalRefitOptions& options, std::size_t normals = 3) {
    return invalid_argument_of([&] {
      (void)refit_normals(random_points(3, 1), std::vector<Vec3>(normals), star(3), options);
    });
  };
  EXPECT_EQ(error({}), "normal_refit.position_scale must be > 0, got 0");
  EXPECT_THAT(error({.position_scale = std::nan("")}), StartsWith("normal_refit.position_scale"));
  EXPECT_EQ(error({.position_scale = 1, .normal_scale = -2}),
            "normal_refit.normal_scale must be > 0, got -2");
  EXPECT_EQ(error({.position_scale = 1, .blend = 1.5}),
            "normal_refit.blend must be in [0, 1], got 1.5");
  EXPECT_EQ(error({.position_scale = 1}, 2), "normals must have one entry per point (3), got 2");
  EXPECT_EQ(error({.position_scale = 1}), "");
}

}  // namespace
}  // namespace deburr

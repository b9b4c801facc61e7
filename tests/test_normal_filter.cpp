// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "deburr/normal_filter.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"
#include "support/stage_oracle.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Vec3 up{0, 0, 1};

void expect_equals_oracle(Normals normals, const Neighborhoods& near,
                          const NormalFilterOptions& options, Voteless voteless) {
  std::vector<Vec3> expected;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    expected.push_back(oracle::filtered_normal(normals, i, near[i], options, voteless));
  }
  EXPECT_LE(max_difference(filter_normals(normals, near, options, voteless), expected), 1e-9);
}

TEST(FilterNormals, EqualsTheOracle) {
  const Neighborhoods near = find_neighbors(random_points(400, 1), {.radius = 0.25});
  // Wide and narrow votes: one, two and three dominant directions, and points without a vote.
  for (const double spread : {0.2, 0.8, 3.0}) {
    std::vector<Vec3> normals = tilted(std::vector<Vec3>(400, up), spread, 2);
    for (std::size_t i = 0; i < normals.size(); i += 17) normals[i] = {};
    for (const double rho : {0.0, 0.3, 0.9, 0.999}) {
      for (const Voteless voteless : {Voteless::Keep, Voteless::Zero}) {
        expect_equals_oracle(normals, near, {.rho = rho}, voteless);
        expect_equals_oracle(normals, near, {.rho = rho, .tau = 0.1, .damping = 0.5}, voteless);
      }
    }
  }
}

TEST(FilterNormals, ProjectsOnTheOneDirectionOfAPlane) {
  const Neighborhoods near = find_neighbors(random_points(5, 3), {.max_count = 4});
  const std::vector<Vec3> normals{{0.28, 0, 0.96}, up, up, up, up};
  // Votes along z alone: B n is (0, 0, 0.96), so that 3 n + B n = (0.84, 0, 3.84).
  const Vec3 expected = (1 / std::hypot(0.84, 3.84)) * Vec3{0.84, 0, 3.84};
  EXPECT_LE(norm(filter_normals(normals, near)[0] - expected), 1e-15);
  // Without damping only the projection is left.
  EXPECT_LE(norm(filter_normals(normals, near, {.damping = 0})[0] - up), 1e-15);
}

TEST(FilterNormals, TakesNoiseOffAPlane) {
  const Sampled plane = plane_grid(30);
  std::vector<Vec3> normals = tilted(plane.normals, 0.15, 4);
  const Neighborhoods near = find_neighbors(plane.points, {.radius = 3});
  const auto error = [&] {
    return mean_of(normals.size(), [&](std::size_t i) { return angle(normals[i], up); });
  };
  const double before = error();
  for (int round = 0; round < 10; ++round) normals = filter_normals(normals, near);
  EXPECT_LT(error(), 0.2 * before);
}

TEST(FilterNormals, DoesNotBlendAcrossAnEdge) {
  const Sampled truth = cube_grid(12);
  std::vector<Vec3> normals = tilted(truth.normals, 0.08, 5);
  const Neighborhoods near = find_neighbors(truth.points, {.radius = 0.5});
  for (int round = 0; round < 20; ++round) normals = filter_normals(normals, near);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    ASSERT_LT(angle(normals[i], truth.normals[i]), 2) << i;
  }
}

TEST(FilterNormals, LeavesExactNormalsAlone) {
  const Sampled truth = cube_grid(8);
  const Neighborhoods near = find_neighbors(truth.points, {.radius = 0.6});
  EXPECT_LE(max_difference(filter_normals(truth.normals, near), truth.normals), 1e-15);
}

TEST(FilterNormals, KeepsOrZeroesThoseWithoutAVote) {
  const Neighborhoods near = find_neighbors(random_points(2, 6), {.max_count = 1});
  const Vec3 side{1, 0, 0};
  const std::vector<Vec3> normals{up, side};
  EXPECT_THAT(filter_normals(normals, near, {}, Voteless::Keep), ElementsAre(up, side));
  EXPECT_THAT(filter_normals(normals, near, {}, Voteless::Zero), ElementsAre(Vec3{}, Vec3{}));
  // Opposite sides do not vote for each other: the test is signed.
  const std::vector<Vec3> opposite{up, -up};
  EXPECT_THAT(filter_normals(opposite, near, {}, Voteless::Zero), ElementsAre(Vec3{}, Vec3{}));
}

TEST(FilterNormals, NeitherHearsNorChangesZeroNormals) {
  const Neighborhoods near = find_neighbors(random_points(3, 7), {.max_count = 2});
  const std::vector<Vec3> normals{{}, up, {}};
  const NormalFilterOptions all{.rho = 0};
  EXPECT_THAT(filter_normals(normals, near, all, Voteless::Keep), ElementsAre(Vec3{}, up, Vec3{}));
  EXPECT_THAT(filter_normals(normals, near, all, Voteless::Zero),
              ElementsAre(Vec3{}, Vec3{}, Vec3{}));
}

TEST(FilterNormals, TakesTheThresholdStrictly) {
  const Neighborhoods near = find_neighbors(random_points(2, 8), {.max_count = 1});
  const std::vector<Vec3> normals{up, {0.6, 0, 0.8}};
  const NormalFilterOptions at{.rho = 0.8};
  EXPECT_EQ(filter_normals(normals, near, at, Voteless::Zero)[0], Vec3{});
  const NormalFilterOptions below{.rho = 0.8 - 1e-15};
  EXPECT_NE(filter_normals(normals, near, below, Voteless::Zero)[0], Vec3{});
}

TEST(FilterNormals, FlipsWithItsInput) {
  const Neighborhoods near = find_neighbors(random_points(200, 9), {.max_count = 20});
  const std::vector<Vec3> normals = tilted(std::vector<Vec3>(200, up), 0.4, 10);
  const auto flip = [](const Vec3& n) { return -n; };
  EXPECT_EQ(filter_normals(mapped(normals, flip), near),
            mapped(filter_normals(normals, near), flip));
}

TEST(FilterNormals, IsTheSameForAnyNumberOfThreads) {
  const Neighborhoods near = find_neighbors(random_points(4000, 11), {.max_count = 20});
  const std::vector<Vec3> normals = tilted(std::vector<Vec3>(4000, up), 0.4, 12);
  const auto run = [&](int threads) {
    return filter_normals(normals, near, {}, Voteless::Keep, {.threads = threads});
  };
  const std::vector<Vec3> one = run(1);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(run(threads), one);
}

TEST(FilterNormals, NamesTheWrongOption) {
  EXPECT_THAT(filter_normals({}, {}), IsEmpty());
  const auto error = [](const NormalFilterOptions& options) {
    return invalid_argument_of([&] { (void)filter_normals({}, {}, options); });
  };
  EXPECT_EQ(error({.rho = 1}), "normal_filter.rho must be in [0, 1), got 1");
  EXPECT_EQ(error({.rho = -0.5}), "normal_filter.rho must be in [0, 1), got -0.5");
  EXPECT_EQ(error({.rho = std::nan("")}), "normal_filter.rho must be in [0, 1), got nan");
  EXPECT_EQ(error({.tau = 0}), "normal_filter.tau must be in (0, 1), got 0");
  EXPECT_EQ(error({.tau = 1}), "normal_filter.tau must be in (0, 1), got 1");
  EXPECT_EQ(error({.damping = -0.5}), "normal_filter.damping must be in [0, 1e6], got -0.5");
  EXPECT_EQ(error({.rho = 0, .damping = 0}), "");
  EXPECT_EQ(invalid_argument_of([] { (void)filter_normals(std::vector<Vec3>(2), {}); }),
            "neighborhoods must have one entry per point (2), got 0");
}

}  // namespace
}  // namespace deburr

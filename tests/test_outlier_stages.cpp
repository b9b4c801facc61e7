// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "kd_tree.hpp"
#include "outlier_graph.hpp"
#include "outlier_knots.hpp"
#include "outlier_patch.hpp"
#include "outlier_threshold.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

/// z = 0.2 x^2 - 0.1 x y + 0.3 over [-1, 1]^2.
std::vector<Vec3> saddle(std::size_t n, unsigned seed) {
  return mapped(random_points(n, seed), [](const Vec3& p) {
    const double x = 2 * p.x - 1;
    const double y = 2 * p.y - 1;
    return Vec3{x, y, 0.2 * x * x - 0.1 * x * y + 0.3};
  });
}

// The frame is tilted against x, y and z, so that the quadric is not met exactly.
TEST(Patch, FollowsAQuadric) {
  const Patch patch = fit_patch(saddle(40, 1), {0, 0, 0});
  for (const Vec3& p : saddle(100, 2)) EXPECT_LT(foot_on(patch, p).distance, 0.02);
  EXPECT_LT(patch.spread, 0.01);
  const Vec3 above{0.1, 0.2, 0.8};
  const Foot foot = foot_on(patch, above);
  EXPECT_NEAR(foot.distance, 0.5, 0.02);
  EXPECT_LT(foot_on(patch, foot.at).distance, 0.02);
}

TEST(Patch, IsNotDrawnToPointsFarOff) {
  std::vector<Vec3> points = saddle(40, 3);
  for (std::size_t i = 0; i < 6; ++i) points[7 * i].z += 0.8;
  const Patch patch = fit_patch(points, {0, 0, 0});
  EXPECT_LT(foot_on(patch, {0, 0, 0.3}).distance, 0.03);
}

TEST(Patch, BearsALineAndKnowsABall) {
  const auto line = mapped(random_points(30, 4), [](const Vec3& p) {
    return Vec3{p.x, 2 * p.x, p.x};
  });
  EXPECT_LT(foot_on(fit_patch(line, line[0]), {0.5, 1, 0.5}).distance, 1e-9);
  EXPECT_LT(fit_patch(saddle(60, 5), {}).flatness, 0.25);
  EXPECT_GT(fit_patch(random_points(60, 6), {}).flatness, 0.6);
}

TEST(Threshold, IsStrictWhereNothingStandsOut) {
  std::vector<double> scores;
  Random random(7);
  for (int i = 0; i < 20000; ++i) scores.push_back(std::abs(random.gaussian()));
  EXPECT_NEAR(score_threshold(scores, {}), 4, 0.1);
  // Where the noise is larger than scores say, they are all too large.
  for (double& s : scores) s *= 1.5;
  EXPECT_NEAR(score_threshold(scores, {}), 6, 0.2);
}

// As many points of the surface are flagged as outliers stay.
TEST(Threshold, DependsOnHowDenseOutliersAre) {
  std::vector<double> noise;
  Random random(8);
  for (int i = 0; i < 20000; ++i) noise.push_back(std::abs(random.gaussian()));
  const auto threshold = [&](double factor, double reach) {
    std::vector<double> scores = noise;
    for (double& s : scores) s *= factor;
    for (int i = 0; i < 1400; ++i) scores.push_back(reach * random.uniform());
    scores.push_back(std::numeric_limits<double>::infinity());
    return score_threshold(scores, {});
  };
  // 14 in each unit of the score: 20000 erfc(3.07 / sqrt 2) = 43 = 14 * 3.07.
  EXPECT_NEAR(threshold(1, 100), 3.07, 0.12);
  EXPECT_NEAR(threshold(1, 1000), 3.63, 0.15);
  // Scores that are too large, or too small, by a factor.
  EXPECT_NEAR(threshold(1.5, 150), 1.5 * 3.07, 0.25);
  EXPECT_NEAR(threshold(0.85, 85), 0.85 * 3.07, 0.12);
  // So dense that noise hides a third: 4 % of the others are 39 = 20000 erfc(3.1 / sqrt 2).
  EXPECT_NEAR(threshold(1, 10), 3.1, 0.15);
}

TEST(Groups, TellSurfaceFromCrumbs) {
  std::vector<Vec3> points = sphere(2000, 9).points;
  points.push_back({0, 0, 1.5});
  for (const Vec3& p : random_points(30, 10)) points.push_back(0.1 * p + Vec3{0, 0, 2});
  for (const Vec3& p : random_points(30, 11)) points.push_back({0.1 * p.x + 2, 0.1 * p.y, 0});
  const std::vector<Standing> standing = join_points(points, KdTree(points), 100, {});
  // Few are cut off by chance.
  EXPECT_LE(std::count(standing.begin(), standing.begin() + 2000, Standing::Loose), 20);
  EXPECT_EQ(std::count(standing.begin() + 2000, standing.begin() + 2031, Standing::Loose), 31);
  EXPECT_EQ(std::count(standing.begin() + 2031, standing.end(), Standing::Patch), 30);
}

// 32 points of noise half as thick as the spacing is wide, or five times as thick.
TEST(Knots, AreThinnedWhereTheNoiseIsThick) {
  const auto square = mapped(random_points(20000, 12), [](const Vec3& p) {
    return Vec3{p.x, p.y, 0};
  });
  const double spacing = 1 / std::sqrt(20000.0);
  for (const double noise : {0.0, 0.5, 5.0}) {
    const std::vector<Vec3> points = with_noise(square, noise * spacing, 13);
    const KdTree tree(points);
    const SomePoints all(points, tree);
    const Knots knots(all, {});
    EXPECT_EQ(knots.group() == 1, noise < 1) << noise;
    std::vector<Vec3> near;
    const Patch patch = knots.patch_at({0.5, 0.5, 0}, no_point, near);
    EXPECT_GE(patch.radius, 3.8 * noise * spacing) << noise;
    EXPECT_LE(patch.radius, std::max(4.0, 8 * noise) * spacing) << noise;
    EXPECT_LT(foot_on(patch, {0.5, 0.5, 0}).distance, 0.8 * noise * spacing + 1e-9) << noise;
  }
}

TEST(KdTree, FindsWhatIsNearestToAnyPlace) {
  const std::vector<Vec3> points = random_points(500, 14);
  const KdTree tree(points);
  std::vector<Found> found;
  for (const Vec3& at : random_points(20, 15)) {
    std::vector<Found> all;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (i != 7) all.push_back({squared_norm(points[i] - at), i});
    }
    std::sort(all.begin(), all.end());
    for (const std::size_t count : {1U, 20U, 64U, 65U, 499U}) {
      tree.nearest_to(at, count, std::numeric_limits<double>::infinity(), found, 7);
      ASSERT_EQ(found.size(), count);
      for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(found[k].index, all[k].index);
    }
  }
}

// Medians of groups may coincide where points are dense to the last bit.
TEST(Patch, OfOnePlaceIsLevel) {
  const Vec3 place{0.3, -0.2, 0.1};
  const Patch patch = fit_patch(std::vector<Vec3>(36, place), place);
  EXPECT_GT(patch.radius, 0);
  EXPECT_EQ(foot_on(patch, place).at, place);
  const Foot foot = foot_on(patch, place + Vec3{1, 1, 1});
  EXPECT_TRUE(is_finite(foot.at));
  EXPECT_NEAR(foot.distance, 1, 1e-12);
  EXPECT_NEAR(foot.aside, std::sqrt(2), 1e-12);
}

}  // namespace
}  // namespace deburr

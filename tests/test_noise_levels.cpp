// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>

#include "deburr/denoise.hpp"
#include "deburr/synth.hpp"
#include "noise_levels.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

double mean_error(const std::vector<Vec3>& points) {
  double sum = 0;
  for (const Vec3& p : points) sum += distance_to_sphere(p);
  return sum / static_cast<double>(points.size());
}

TEST(FindNoiseLevels, TakesNearlyEqualNoiseForOne) {
  EXPECT_TRUE(find_noise_levels({}, 0.1).sigma.empty());
  EXPECT_TRUE(find_noise_levels(std::vector<double>{1, 1.1, 1.3, 1.5}, 0.1).sigma.empty());
  // What is below the least is the least.
  EXPECT_TRUE(find_noise_levels(std::vector<double>{0, 0.01, 0.05, 0.1}, 0.1).sigma.empty());
}

TEST(FindNoiseLevels, PutsEveryPointBetweenLevels) {
  std::vector<double> local(101);
  for (std::size_t i = 0; i < local.size(); ++i) local[i] = 1 + 0.04 * static_cast<double>(i);
  const NoiseLevels levels = find_noise_levels(local, 0.1);
  ASSERT_EQ(levels.sigma.size(), 3);
  EXPECT_DOUBLE_EQ(levels.sigma[1], 2 * levels.sigma[0]);
  EXPECT_DOUBLE_EQ(levels.sigma[2], 4 * levels.sigma[0]);
  EXPECT_EQ(levels.at.front(), 0);
  EXPECT_EQ(levels.at.back(), 2);
  EXPECT_TRUE(std::ranges::is_sorted(levels.at));
  // Twice the noise of the lowest level, 1.08, is one level up.
  EXPECT_NEAR(levels.at[29], 1, 1e-12);
}

// Noise that grows fivefold from one side to the other.
TEST(Denoise, FollowsTheNoiseFromPlaceToPlace) {
  constexpr std::size_t n = 4000;
  PointCloud cloud;
  cloud.points = sphere(n, 1).points;
  Random random(2);
  for (Vec3& p : cloud.points) {
    const double sigma = 0.056 * (0.6 + 0.4 * p.x);
    const Vec3 step{random.gaussian(), random.gaussian(), random.gaussian()};
    p += sigma * step;
  }
  const DenoiseResult local = denoise(cloud);
  const DenoiseResult global = denoise(cloud, {.automatic = {.noise = local.report.noise}});
  EXPECT_LT(mean_error(local.cloud.points), 0.75 * mean_error(global.cloud.points));
  EXPECT_GT(local.report.max_move, 4 * local.report.noise);
  for (const double d : local.displacement) EXPECT_LE(d, local.report.max_move);
  const DenoiseResult bounded = denoise(cloud, {.automatic = {.max_move = 0.01}});
  for (const double d : bounded.displacement) EXPECT_LE(d, 0.01);
}

// A level between two noises that lie far apart has no points.
TEST(DenoiseAtLevels, NeedsNoPointsAtALevel) {
  const std::vector<Vec3> points = with_noise(sphere(400, 1).points, 0.02, 2);
  NoiseLevels levels;
  levels.sigma = {0.02, 0.04, 0.08, 0.16, 0.32};
  levels.at.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) levels.at[i] = points[i].x > 0 ? 4 : 0;
  AutomaticInput input;
  input.points = points;
  input.spacing = 0.18;
  const Execution execution;
  StageClock clock(execution);
  const AutomaticResult result = denoise_at_levels(input, levels, 0, 4, clock, execution);
  ASSERT_EQ(result.points.size(), points.size());
  for (const Vec3& p : result.points) EXPECT_LT(distance_to_sphere(p), 0.5);
}

// Patches over its edges seem to have noise, others none.
TEST(Denoise, TakesNoDetailOfAnExactPartForNoise) {
  const SyntheticScan scan = synthesize(Shape::Part, {.points = 1000, .noise = 0});
  double moved = 0;
  for (const double d : denoise(scan.cloud).displacement) moved += d;
  EXPECT_LT(moved / 1000, 0.01 * scan.spacing);
}

TEST(Denoise, HasOneLevelWhereTheNoiseIsOne) {
  PointCloud cloud;
  cloud.points = with_noise(sphere(2000, 3).points, 0.04, 4);
  const DenoiseResult local = denoise(cloud);
  EXPECT_EQ(local.report.max_move, 4 * local.report.noise);
  const DenoiseResult global = denoise(cloud, {.automatic = {.noise = local.report.noise}});
  EXPECT_EQ(local.cloud.points, global.cloud.points);
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deburr/neighborhoods.hpp"
#include "deburr/noise.hpp"
#include "local_noise.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

using testing::Each;

constexpr std::size_t many = 20000;
const double spacing = 1 / std::sqrt(static_cast<double>(many));

/// A square whose noise grows fourfold from left to right.
std::vector<Vec3> square_with_growing_noise(double left) {
  Random random(2);
  return mapped(random_points(many, 1), [&](const Vec3& p) {
    const double sigma = left * spacing * std::exp2(2 * p.x);
    return Vec3{p.x, p.y, sigma * random.gaussian()};
  });
}

TEST(LocalNoise, FollowsNoiseThatGrows) {
  for (const double left : {0.1, 0.5}) {
    const std::vector<Vec3> points = square_with_growing_noise(left);
    const LocalNoise noise = estimate_local_noise(points);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < points.size(); ++i) {
      ratios.push_back(noise.sigma[i] / (left * spacing * std::exp2(2 * points[i].x)));
    }
    std::ranges::sort(ratios);
    // The overall value alone would be off by two either way.
    EXPECT_GT(ratios[many / 10], 0.75) << left;
    EXPECT_LT(ratios[9 * many / 10], 1.33) << left;
  }
}

TEST(LocalNoise, IsTheOverallNoiseWhereNothingElseIsEvident) {
  const std::vector<Vec3> points = cube(many, 3).points;  // spacing 0.035
  for (const double sigma : {0.0035, 0.035}) {
    const std::vector<Vec3> noisy = with_noise(points, sigma, 4);
    const LocalNoise noise = estimate_local_noise(noisy);
    EXPECT_EQ(noise.overall.sigma, estimate_noise(noisy));
    std::size_t same = 0;
    for (const double s : noise.sigma) same += std::abs(s / sigma - 1) < 0.15 ? 1 : 0;
    EXPECT_GT(same, 98 * many / 100) << sigma;
  }
}

TEST(LocalNoise, FollowsTheSpacing) {
  // Density falls as 1 / x from 1 to 4.
  const std::vector<Vec3> points = mapped(random_points(many, 5), [](const Vec3& p) {
    return Vec3{std::exp2(2 * p.x), 3 * p.y, 0};
  });
  const LocalNoise noise = estimate_local_noise(points);
  for (std::size_t i = 0; i < many; i += 100) {
    const double density = static_cast<double>(many) / (points[i].x * std::log(4) * 3);
    EXPECT_NEAR(noise.spacing[i] * std::sqrt(density), 1, 0.2) << points[i].x;
  }
  EXPECT_THAT(noise.sigma, Each(testing::Lt(1e-12)));
}

TEST(LocalNoise, HasAValueForEveryPoint) {
  std::vector<Vec3> points = square_with_growing_noise(0.2);
  points[7].x = std::numeric_limits<double>::quiet_NaN();
  points[9] = points[8];
  const LocalNoise noise = estimate_local_noise(points);
  ASSERT_EQ(noise.sigma.size(), points.size());
  ASSERT_EQ(noise.spacing.size(), points.size());
  EXPECT_EQ(noise.sigma[7], noise.overall.sigma);
  EXPECT_EQ(noise.spacing[7], noise.overall.spacing);
  EXPECT_EQ(noise.sigma[9], noise.sigma[8]);
}

TEST(LocalNoiseField, SaysAtPlacesWhatItSaysAtPoints) {
  LocalNoiseField field(square_with_growing_noise(0.3), {});
  std::vector<double> places = field.sigma_at_places({});
  std::vector<double> points = field.at_points({}).sigma;
  ASSERT_GT(places.size(), 500);
  std::ranges::sort(places);
  std::ranges::sort(points);
  for (const double share : {0.1, 0.5, 0.9}) {
    const auto at = [&](const std::vector<double>& values) {
      return values[static_cast<std::size_t>(share * static_cast<double>(values.size()))];
    };
    EXPECT_NEAR(at(places) / at(points), 1, 0.1) << share;
  }
}

TEST(LocalNoiseField, FindsTheMeanDistanceOfNeighbors) {
  // All points are places of the sample, or some are.
  for (const std::size_t n : {3000, 12000}) {
    const std::vector<Vec3> points = cube(n, 8).points;
    const double all = mean_neighbor_distance(points, find_neighbors(points, {.max_count = 12}));
    EXPECT_NEAR(LocalNoiseField(points, {}).neighbor_distance(12, {}) / all, 1,
                n == 3000 ? 1e-12 : 0.02);
  }
  EXPECT_EQ(LocalNoiseField(std::vector<Vec3>{{1, 2, 3}}, {}).neighbor_distance(12, {}), 0);
  EXPECT_EQ(LocalNoiseField(std::vector<Vec3>{{1, 2, 3}, {1, 2, 5}}, {}).neighbor_distance(12, {}),
            2);
}

TEST(LocalNoise, IsZeroForFewPoints) {
  const LocalNoise noise = estimate_local_noise(random_points(15, 6));
  EXPECT_THAT(noise.sigma, testing::AllOf(testing::SizeIs(15), Each(0)));
  EXPECT_THAT(noise.spacing, testing::AllOf(testing::SizeIs(15), Each(0)));
  EXPECT_THAT(estimate_local_noise({}).sigma, testing::IsEmpty());
}

TEST(LocalNoise, DoesNotDependOnUnitOrderAndThreads) {
  const std::vector<Vec3> points = square_with_growing_noise(0.2);
  const std::vector<double> sigma = estimate_local_noise(points, {.threads = 1}).sigma;
  EXPECT_EQ(estimate_local_noise(points, {.threads = 3}).sigma, sigma);
  const LocalNoise scaled =
      estimate_local_noise(mapped(points, [](const Vec3& p) { return 0x1p+60 * p; }));
  const std::vector<std::uint32_t> order = random_permutation(many, 7);
  std::vector<Vec3> shuffled;
  for (const std::uint32_t i : order) shuffled.push_back(points[i]);
  const std::vector<double> other = estimate_local_noise(shuffled).sigma;
  for (std::size_t i = 0; i < many; ++i) {
    ASSERT_EQ(scaled.sigma[i], 0x1p+60 * sigma[i]);
    ASSERT_EQ(other[i], sigma[order[i]]);
  }
}

}  // namespace
}  // namespace deburr

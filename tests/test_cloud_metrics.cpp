// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deburr/cloud_metrics.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

double nearest(const Vec3& p, Points cloud) {
  double best = infinity;
  for (const Vec3& q : cloud) best = std::fmin(best, norm(p - q));
  return best;
}

/// By the definition: normalise both clouds, then add the mean squares of both directions.
double chamfer_by_hand(std::vector<Vec3> cloud, std::vector<Vec3> truth) {
  Vec3 low = truth[0];
  Vec3 high = truth[0];
  for (const Vec3& p : truth) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 centre = 0.5 * (low + high);
  double largest = 0;
  for (const Vec3& p : truth) largest = std::max(largest, norm(p - centre));
  for (Vec3& p : cloud) p = (1 / largest) * (p - centre);
  for (Vec3& p : truth) p = (1 / largest) * (p - centre);
  const auto mean_square = [](const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
    return mean_of(from.size(), [&](std::size_t i) { return std::pow(nearest(from[i], to), 2); });
  };
  return 1e4 * (mean_square(cloud, truth) + mean_square(truth, cloud));
}

TEST(DistanceToCloud, EqualsBruteForce) {
  std::vector<Vec3> cloud = random_points(300, 1);
  cloud.push_back({nan, 0, 0});
  std::vector<Vec3> points = with_noise(cloud, 0.1, 2);
  points.push_back({50, 60, 70});
  const std::vector<double> distances = distance_to_cloud(points, cloud);
  ASSERT_EQ(distances.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_finite(points[i])) {
      ASSERT_EQ(distances[i], nearest(points[i], cloud)) << i;
    } else {
      ASSERT_TRUE(std::isnan(distances[i])) << i;
    }
  }
}

// The truth has its middle at (2, 0, 0) and its farthest point 2 away.
TEST(CompareToCloud, IsThatDerivedByHand) {
  const std::vector<Vec3> truth{{0, 0, 0}, {4, 0, 0}};
  const std::vector<Vec3> points{{0, 0, 1}, {nan, 0, 0}, {4, 0, 0}, {4, 3, 0}};
  const CloudError error = compare_to_cloud(points, truth);
  EXPECT_EQ(error.to_truth.count, 3U);
  EXPECT_DOUBLE_EQ(error.to_truth.mean, 4.0 / 3);
  EXPECT_DOUBLE_EQ(error.to_truth.rms, std::sqrt(10.0 / 3));
  EXPECT_EQ(error.to_truth.percentile_95, 3);
  EXPECT_EQ(error.to_truth.maximum, 3);
  EXPECT_EQ(error.to_truth.diagonal, 4);
  EXPECT_EQ(error.coverage.count, 2U);
  EXPECT_EQ(error.coverage.mean, 0.5);
  EXPECT_EQ(error.coverage.maximum, 1);
  EXPECT_EQ(error.coverage.diagonal, 4);
  EXPECT_DOUBLE_EQ(error.chamfer, 1e4 * (10.0 / 3 + 1.0 / 2) / 4);
}

TEST(CompareToCloud, EqualsTheDefinitionOfChamfer) {
  const std::vector<Vec3> truth = mapped(sphere(400, 1).points, [](const Vec3& p) {
    return Vec3{3 * p.x + 10, p.y, 2 * p.z - 5};
  });
  const std::vector<Vec3> cloud = with_noise(random_points(300, 2), 1, 3);
  const double expected = chamfer_by_hand(cloud, truth);
  EXPECT_NEAR(compare_to_cloud(cloud, truth).chamfer, expected, 1e-13 * expected);
}

TEST(CompareToCloud, ChamferHasNoUnitAndNoOrigin) {
  const std::vector<Vec3> truth = sphere(300, 1).points;
  const std::vector<Vec3> cloud = with_noise(sphere(300, 2).points, 0.05, 3);
  const double before = compare_to_cloud(cloud, truth).chamfer;
  for (const double scale : {1e-6, 1e6}) {
    const auto move = [&](const Vec3& p) { return scale * (p + Vec3{1000, -500, 20}); };
    // Coordinates of 1000 are rounded to 1e-13, relative to distances of some hundredths.
    EXPECT_NEAR(compare_to_cloud(mapped(cloud, move), mapped(truth, move)).chamfer, before,
                1e-10 * before);
  }
}

TEST(CompareToCloud, HasNoChamferWithoutAScaleOrPoints) {
  const std::vector<Vec3> one{{1, 1, 1}};
  const std::vector<Vec3> none{{nan, 1, 1}};
  const CloudError at_one_place = compare_to_cloud(random_points(5, 1), one);
  EXPECT_TRUE(std::isnan(at_one_place.chamfer));
  EXPECT_EQ(at_one_place.to_truth.count, 5U);
  for (const auto& [cloud, truth] : {std::pair{none, one}, {one, none}, {none, none}}) {
    const CloudError error = compare_to_cloud(cloud, truth);
    EXPECT_TRUE(std::isnan(error.chamfer));
    EXPECT_EQ(error.to_truth.count, 0U);
    EXPECT_EQ(error.coverage.count, 0U);
    EXPECT_EQ(error.to_truth.mean, 0);
  }
  EXPECT_TRUE(std::isnan(distance_to_cloud(one, none)[0]));
}

TEST(CompareToCloud, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Vec3> truth = random_points(3000, 1);
  const std::vector<Vec3> cloud = random_points(4000, 2);
  const CloudError one = compare_to_cloud(cloud, truth, {.threads = 1});
  const CloudError three = compare_to_cloud(cloud, truth, {.threads = 3});
  EXPECT_EQ(one.chamfer, three.chamfer);
  EXPECT_EQ(one.to_truth.mean, three.to_truth.mean);
}

}  // namespace
}  // namespace deburr

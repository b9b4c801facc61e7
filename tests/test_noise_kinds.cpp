// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "deburr/noise.hpp"
#include "support/shapes.hpp"

// Noise that is not the same normal one in all directions at all points of a closed surface.

namespace deburr {
namespace {

constexpr std::size_t many = 12000;
const double spacing = std::sqrt(4 * std::numbers::pi / static_cast<double>(many));

TEST(EstimateNoise, FindsNoiseAlongNormals) {
  for (const double share : {0.1, 0.5, 2.0}) {
    Sampled truth = sphere(many, 1);
    Random random(2);
    for (std::size_t i = 0; i < many; ++i) {
      truth.points[i] += share * spacing * random.gaussian() * truth.normals[i];
    }
    EXPECT_NEAR(estimate_noise(truth.points) / spacing, share, 0.1 * share);
  }
}

// Half of the points are exact, the others off by sqrt(2) sigma along each axis.
TEST(EstimateNoise, IsTheRootMeanSquareOfImpulses) {
  for (const double share : {0.1, 0.4, 1.0, 3.0}) {
    std::vector<Vec3> points = sphere(many, 3).points;
    Random random(4);
    for (Vec3& p : points) {
      const Vec3 step{random.gaussian(), random.gaussian(), random.gaussian()};
      if (random.uniform() < 0.5) p += share * spacing * std::numbers::sqrt2 * step;
    }
    EXPECT_NEAR(estimate_noise(points) / spacing, share, 0.15 * share);
  }
}

TEST(EstimateNoise, DoesNotCountDuplicates) {
  const std::vector<Vec3> points = with_noise(sphere(many, 5).points, 0.3 * spacing, 6);
  const double noise = estimate_noise(points);
  std::vector<Vec3> more = points;
  for (std::size_t i = 0; i < points.size(); i += 2) more.push_back(points[i]);
  EXPECT_EQ(estimate_noise(more), noise);
  // Neither where rounding has set them apart.
  for (std::size_t i = points.size(); i < more.size(); ++i) more[i] = (1 + 1e-9) * more[i];
  EXPECT_NEAR(estimate_noise(more), noise, 0.1 * noise);
}

TEST(EstimateNoise, IsNotMisledByOutliers) {
  for (const double share : {0.0, 0.1, 1.0}) {
    std::vector<Vec3> points = with_noise(sphere(many, 7).points, share * spacing, 8);
    for (const Vec3& p : random_points(many / 20, 9)) points.push_back(4 * (p - Vec3{.5, .5, .5}));
    for (const Vec3& at : random_points(many / 1000, 10)) {
      const std::vector<Vec3> cluster(20, 4 * (at - Vec3{.5, .5, .5}));
      for (const Vec3& p : with_noise(cluster, 0.5 * spacing, 11)) points.push_back(p);
    }
    EXPECT_NEAR(estimate_noise(points) / spacing, share, std::max(0.02, 0.1 * share));
  }
}

// Two sheets three spacings apart are not one with strong noise.
TEST(EstimateNoise, KeepsThinSheetsApart) {
  for (const double share : {0.0, 0.1, 0.3}) {
    std::vector<Vec3> points = random_points(10000, 12);
    const double step = std::sqrt(2.0 / 10000);
    for (Vec3& p : points) p.z = p.z < 0.5 ? 0 : 3 * step;
    EXPECT_NEAR(estimate_noise(with_noise(points, share * step, 13)) / step, share,
                std::max(0.02, 0.1 * share));
  }
}

// As dense as this, a hundred points lie within one standard deviation.
TEST(EstimateNoise, FindsNoiseFarAboveTheSpacing) {
  const std::vector<Vec3> points = mapped(random_points(120000, 14), [](const Vec3& p) {
    return Vec3{p.x, p.y, 0};
  });
  const double sigma = 8 / std::sqrt(120000.0);
  EXPECT_NEAR(estimate_noise(with_noise(points, sigma, 15)), sigma, 0.1 * sigma);
}

}  // namespace
}  // namespace deburr

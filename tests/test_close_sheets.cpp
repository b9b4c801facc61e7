// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "deburr/denoise.hpp"
#include "deburr/noise.hpp"
#include "support/shapes.hpp"
#include "two_sheets.hpp"

// Two sheets that lie so close over each other that their distance could pass for noise.

namespace deburr {
namespace {

/// Two parallel unit squares, `gap` apart.
std::vector<Vec3> plate(std::size_t n, double gap, unsigned seed) {
  std::vector<Vec3> points = random_points(n, seed);
  for (Vec3& p : points) p.z = p.z < 0.5 ? 0 : gap;
  return points;
}

double spacing_of_plate(std::size_t n) { return std::sqrt(2 / static_cast<double>(n)); }

double mean_error(const std::vector<Vec3>& points, double gap) {
  double sum = 0;
  for (const Vec3& p : points) sum += std::min(std::abs(p.z), std::abs(p.z - gap));
  return sum / static_cast<double>(points.size());
}

TEST(FitTwoSheets, FindsTwoBentSheets) {
  std::vector<Vec3> points = plate(400, 0.1, 1);
  for (Vec3& p : points) p.z += 0.3 * p.x - 0.5 * p.x * p.y + 0.2 * p.y * p.y;
  const TwoSheets two = fit_two_sheets(with_noise(points, 0.01, 2), 1);
  EXPECT_NEAR(two.gap, 0.1, 0.003);
  EXPECT_NEAR(std::sqrt(two.variance), 0.01, 0.001);
  EXPECT_NEAR(two.share, 0.5, 0.1);
  EXPECT_GT(two.gain, 100);
  EXPECT_GT(two.mixing, 0.8);
}

TEST(FitTwoSheets, HardlyPrefersThemToOne) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const std::vector<Vec3> points = with_noise(plate(200, 0, seed), 0.01, 100 + seed);
    EXPECT_LT(fit_two_sheets(points, 1).gain, 8) << seed;
  }
}

// The same heights, but one beside the other.
TEST(FitTwoSheets, KnowsAStepByItsMixing) {
  std::vector<Vec3> points = random_points(400, 3);
  for (Vec3& p : points) p.z = std::fmod(3 * p.x, 1.0) < 0.5 ? 0 : 0.1;
  EXPECT_LT(fit_two_sheets(with_noise(points, 0.01, 4), 1).mixing, 0.3);
}

TEST(FitTwoSheets, NeedsPoints) {
  EXPECT_EQ(fit_two_sheets({}, 1).gain, 0);
  EXPECT_EQ(fit_two_sheets(plate(31, 0.1, 5), 1).gain, 0);
  EXPECT_EQ(fit_two_sheets(std::vector<Vec3>(100, Vec3{1, 2, 3}), 1).gap, 0);
}

TEST(MeasureNoise, TellsTheGapFromTheNoise) {
  constexpr std::size_t n = 3000;
  const double h = spacing_of_plate(n);
  for (const double gap : {1.0, 1.6, 2.0, 3.0}) {
    for (const double share : {0.0, 0.1, 0.3, 0.5}) {
      if (gap < 3 * share) continue;
      const auto points = with_noise(plate(n, gap * h, 6), share * h, 7);
      const NoiseEstimate noise = measure_noise(points);
      EXPECT_NEAR(noise.sigma / h, share, std::max(0.02, 0.15 * share)) << gap;
      if (noise.gap > 0) {
        EXPECT_NEAR(noise.gap / h, gap, 0.1 * gap) << share;
      }
    }
  }
}

// Both sheets bend, and one more than the other.
TEST(MeasureNoise, TellsTheGapOfAShell) {
  constexpr std::size_t n = 3000;
  const double h = std::sqrt(8 * std::numbers::pi / n);
  for (const double share : {0.0, 0.2, 0.4}) {
    std::vector<Vec3> points = sphere(n, 8).points;
    for (std::size_t i = 0; i < n; i += 2) points[i] = (1 + 1.5 * h) * points[i];
    const NoiseEstimate noise = measure_noise(with_noise(points, share * h, 9));
    EXPECT_NEAR(noise.sigma / h, share, std::max(0.02, 0.15 * share));
    EXPECT_NEAR(noise.gap / h, 1.5, 0.15);
  }
}

TEST(MeasureNoise, FindsNoGapInOneSheet) {
  for (const double sigma : {0.0, 0.01, 0.05, 0.1}) {
    EXPECT_EQ(measure_noise(with_noise(sphere(3000, 10).points, sigma, 11)).gap, 0) << sigma;
    EXPECT_EQ(measure_noise(with_noise(cube(3000, 12).points, sigma, 13)).gap, 0) << sigma;
  }
}

// As likely everywhere within bounds: flat on top, but with no valley in between.
TEST(MeasureNoise, FindsNoGapInUniformNoise) {
  for (const std::size_t n : {1600U, 5000U}) {
    const double h = 1 / std::sqrt(static_cast<double>(n));
    for (const double width : {0.3, 1.0}) {
      std::vector<Vec3> points = random_points(n, 17);
      for (Vec3& p : points) p.z = (2 * p.z - 1) * width * h;
      const NoiseEstimate noise = measure_noise(points);
      const double sigma = width * h / std::numbers::sqrt3;
      EXPECT_EQ(noise.gap, 0) << width;
      EXPECT_NEAR(noise.sigma, sigma, 0.15 * sigma) << width;
    }
  }
}

TEST(Denoise, LeavesCloseSheetsNoWorse) {
  constexpr std::size_t n = 1500;
  const double h = spacing_of_plate(n);
  struct Case {
    double gap, noise;
  };
  for (const auto& [gap, share] :
       {Case{1, 0.1}, Case{1, 0.3}, Case{1.5, 0.3}, Case{1.6, 0.5}, Case{2, 0.5}, Case{3, 0.5}}) {
    PointCloud cloud;
    cloud.points = with_noise(plate(n, gap * h, 14), share * h, 15);
    const DenoiseResult clean = denoise(cloud);
    EXPECT_LT(mean_error(clean.cloud.points, gap * h), mean_error(cloud.points, gap * h))
        << gap << " " << share;
    EXPECT_LE(clean.report.max_move, 4 * clean.report.noise);
  }
}

TEST(Denoise, LeavesCloseSheetsWithoutNoise) {
  constexpr std::size_t n = 1500;
  const double h = spacing_of_plate(n);
  for (const double gap : {1.0, 1.5, 2.0, 3.0}) {
    PointCloud cloud;
    cloud.points = plate(n, gap * h, 16);
    double moved = 0;
    for (const double d : denoise(cloud).displacement) moved += d;
    EXPECT_LT(moved / n, 0.02 * h) << gap;
  }
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "deburr/noise.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Random in the unit square; the spacing is 1 / sqrt(n).
std::vector<Vec3> random_square(std::size_t n, unsigned seed) {
  return mapped(random_points(n, seed), [](const Vec3& p) { return Vec3{p.x, p.y, 0}; });
}

TEST(EstimateNoise, FindsTheNoiseOfAPlane) {
  const std::vector<Vec3> points = mapped(random_square(10000, 1), random_rotation(2));
  for (const double share : {0.1, 0.5, 1.0, 3.0}) {
    const double sigma = share * 0.01;
    EXPECT_NEAR(estimate_noise(with_noise(points, sigma, 3)), sigma, 0.1 * sigma) << share;
  }
}

TEST(EstimateNoise, FindsTheNoiseOfASphere) {
  const Sampled truth = sphere(12566, 4);
  const double spacing = std::sqrt(4 * std::numbers::pi / 12566);
  for (const double share : {0.1, 0.5, 2.0}) {
    const double sigma = share * spacing;
    EXPECT_NEAR(estimate_noise(with_noise(truth.points, sigma, 5)), sigma, 0.1 * sigma) << share;
  }
}

TEST(EstimateNoise, IsNothingOnAnExactPlane) {
  EXPECT_LT(estimate_noise(mapped(random_square(2000, 6), random_rotation(7))), 1e-15);
  EXPECT_LT(estimate_noise(plane_grid(20).points), 1e-14);
}

TEST(EstimateNoise, IsNotMisledByEdges) {
  const std::vector<Vec3> points = cube(12000, 8).points;  // spacing 0.045
  for (const double sigma : {0.0045, 0.045, 0.09}) {
    EXPECT_NEAR(estimate_noise(with_noise(points, sigma, 9)), sigma, 0.1 * sigma) << sigma;
  }
}

TEST(EstimateNoise, IsNothingOnExactShapes) {
  const double spacing = std::sqrt(4 * std::numbers::pi / 1000);
  EXPECT_LT(estimate_noise(sphere(1000, 22).points), 0.005 * spacing);
  EXPECT_LT(estimate_noise(cube(1000, 23).points), 1e-12);
  EXPECT_LT(estimate_noise(cube_grid(12).points), 1e-12);
}

TEST(MeasureNoise, TellsTheSpacing) {
  const double spacing = std::sqrt(4 * std::numbers::pi / 20000);
  for (const double share : {0.0, 0.5, 2.0}) {
    const NoiseEstimate noise =
        measure_noise(with_noise(sphere(20000, 24).points, share * spacing, 25));
    EXPECT_NEAR(noise.spacing, spacing, 0.06 * spacing) << share;
    EXPECT_GE(noise.reach, 2.8 * noise.sigma);
  }
}

TEST(EstimateNoise, ScalesWithTheUnit) {
  const std::vector<Vec3> points = with_noise(random_square(2000, 10), 0.01, 11);
  const double noise = estimate_noise(points);
  for (const double unit : {0x1p-60, 0x1p+60}) {
    EXPECT_EQ(estimate_noise(mapped(points, [&](const Vec3& p) { return unit * p; })),
              unit * noise);
  }
  EXPECT_NEAR(estimate_noise(mapped(points, [](const Vec3& p) { return 1e-6 * p; })), 1e-6 * noise,
              1e-17);
}

TEST(EstimateNoise, DoesNotDependOnPlaceAndOrder) {
  const std::vector<Vec3> points = with_noise(random_square(2000, 12), 0.01, 13);
  const double noise = estimate_noise(points);
  const Rotation turn = random_rotation(14);
  EXPECT_NEAR(estimate_noise(mapped(points,
                                    [&](const Vec3& p) {
                                      return turn(p) + Vec3{9, 9, 9};
                                    })),
              noise, 1e-12);
  std::vector<Vec3> shuffled;
  for (const std::uint32_t i : random_permutation(points.size(), 15)) shuffled.push_back(points[i]);
  EXPECT_EQ(estimate_noise(shuffled), noise);
}

TEST(EstimateNoise, IsZeroForFewPoints) {
  EXPECT_EQ(estimate_noise({}), 0);
  EXPECT_EQ(estimate_noise(random_points(15, 16)), 0);
  EXPECT_GT(estimate_noise(random_points(16, 16)), 0);
  EXPECT_EQ(estimate_noise(std::vector<Vec3>(100, {1, 2, 3})), 0);
}

// Squares of the distances overflow.
TEST(EstimateNoise, IsFiniteForHugeCoordinates) {
  for (const double unit : {1e154, 1e160, 1e200, 1e308}) {
    const std::vector<Vec3> points = random_points(500, 21);
    EXPECT_TRUE(
        std::isfinite(estimate_noise(mapped(points, [&](const Vec3& p) { return unit * p; }))))
        << unit;
  }
}

TEST(EstimateNoise, LeavesOutPointsThatAreNotFinite) {
  std::vector<Vec3> points = with_noise(random_square(1000, 17), 0.01, 18);
  const double noise = estimate_noise(points);
  points.insert(points.begin() + 500, {not_a_number, 0, 0});
  points.push_back({0, 0, std::numeric_limits<double>::infinity()});
  EXPECT_EQ(estimate_noise(points), noise);
  EXPECT_EQ(estimate_noise(std::vector<Vec3>(50, {0, not_a_number, 0})), 0);
}

TEST(EstimateNoise, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Vec3> points = with_noise(random_square(5000, 19), 0.01, 20);
  const double one = estimate_noise(points, {.threads = 1});
  for (const int threads : {2, 3, 7}) EXPECT_EQ(estimate_noise(points, {.threads = threads}), one);
}

}  // namespace
}  // namespace deburr

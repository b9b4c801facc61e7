// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <limits>
#include <numbers>

#include "deburr/outliers.hpp"
#include "support/compare.hpp"
#include "support/outlier_clouds.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t cloud_size = 8000;
constexpr double diagonal = 2 * std::numbers::sqrt3;  // of the cube and of the sphere

const double cube_spacing = std::sqrt(24.0 / cloud_size);
const double sphere_spacing = std::sqrt(4 * std::numbers::pi / cloud_size);

Spoiled spoiled_cube(double noise, unsigned seed) {
  return spoil(cube(cloud_size, seed).points, cube_spacing, noise * diagonal, seed + 100,
               distance_to_cube);
}

std::vector<Vec3> random_square(std::size_t n, unsigned seed) {
  return mapped(random_points(n, seed), [](const Vec3& p) { return Vec3{p.x, p.y, 0}; });
}

// Up to half a percent. Beyond, more than one outlier in twenty is within the noise of the cube.
TEST(FindOutliers, FindsThoseAroundACube) {
  for (const double noise : {0.0, 0.001, 0.0025, 0.005}) {
    const Spoiled cloud = spoiled_cube(noise, 1);
    const Agreement found = agreement(find_outliers(cloud.points), cloud.outlier);
    EXPECT_GE(found.recall, 0.95) << noise;
    EXPECT_GE(found.precision, 0.95) << noise;
  }
}

TEST(FindOutliers, FindsThoseAroundASphere) {
  for (const double noise : {0.0, 0.0025, 0.01}) {
    const Spoiled cloud = spoil(sphere(cloud_size, 2).points, sphere_spacing, noise * diagonal, 3,
                                distance_to_sphere);
    const Agreement found = agreement(find_outliers(cloud.points), cloud.outlier);
    EXPECT_GE(found.recall, 0.95) << noise;
    EXPECT_GE(found.precision, 0.95) << noise;
  }
}

// No more points of the surface are lost than outliers stay, where the noise hides few.
TEST(FindOutliers, LosesFewPointsWhereNoiseHidesFewOutliers) {
  for (const double noise : {0.0025, 0.005}) {
    const Spoiled cloud = spoil(sphere(cloud_size, 2).points, sphere_spacing, noise * diagonal, 3,
                                distance_to_sphere);
    const Agreement found = agreement(find_outliers(cloud.points), cloud.outlier);
    EXPECT_GE(found.recall, 0.975) << noise;
    EXPECT_GE(found.precision, 0.975) << noise;
  }
}

TEST(FindOutliers, FindsEveryPointOfDenseFloaters) {
  const Spoiled cloud = spoiled_cube(0.0025, 4);
  const std::vector<std::uint8_t> flags = find_outliers(cloud.points);
  const std::size_t first = cloud_size + cloud_size / 20;
  EXPECT_EQ(std::count(flags.begin() + first, flags.end(), 0), 0);
}

TEST(FindOutliers, FlagsNextToNothingOfCleanClouds) {
  for (const double noise : {0.0, 0.001, 0.005, 0.01, 0.02}) {
    const double sigma = noise * diagonal;
    EXPECT_LE(share_flagged(find_outliers(with_noise(cube(cloud_size, 5).points, sigma, 6))), 0.002)
        << noise;
    EXPECT_LE(share_flagged(find_outliers(with_noise(sphere(cloud_size, 7).points, sigma, 8))),
              0.002)
        << noise;
  }
  // One or two at a bare corner of a sheet look as if they were past its end.
  EXPECT_LE(share_flagged(find_outliers(random_square(cloud_size, 9))), 0.0003);
  EXPECT_EQ(share_flagged(find_outliers(plane_grid(60).points)), 0);
  EXPECT_EQ(share_flagged(find_outliers(cube_grid(20).points)), 0);
}

// Half of the points are exact, so that half of the residuals say nothing of the others.
TEST(FindOutliers, TakesNoiseOfHalfThePointsForNoise) {
  std::vector<Vec3> points = sphere(cloud_size, 10).points;
  const std::vector<Vec3> noisy = with_noise(points, 0.01 * diagonal, 11);
  for (std::size_t i = 0; i < points.size(); i += 2) points[i] = noisy[i];
  EXPECT_LE(share_flagged(find_outliers(points)), 0.005);
}

// The density falls by a factor of 10 from left to right.
TEST(FindOutliers, BearsUnevenDensity) {
  std::vector<Vec3> points = mapped(random_points(cloud_size, 12), [](const Vec3& p) {
    return Vec3{(std::sqrt(1 - 0.99 * p.x) - 1) / -0.9, p.y, 0};
  });
  points = with_noise(points, 0.003, 13);
  EXPECT_LE(share_flagged(find_outliers(points)), 0.002);
  for (const double x : {0.05, 0.95}) points.push_back({x, 0.5, 0.12});
  const std::vector<std::uint8_t> flags = find_outliers(points);
  EXPECT_EQ(flags[cloud_size], 1);
  EXPECT_EQ(flags[cloud_size + 1], 1);
}

TEST(FindOutliers, FlagsWhatIsPastTheEndOfASheet) {
  std::vector<Vec3> points = random_square(cloud_size, 14);
  // Four spacings past the end, seven from each other, then farther and farther.
  for (int i = 0; i < 10; ++i) points.push_back({1.045, 0.1 + 0.08 * i, 0});
  for (int i = 0; i < 10; ++i) points.push_back({1.2 + 0.1 * i, 0.1 * i, 0});
  const std::vector<std::uint8_t> flags = find_outliers(points);
  EXPECT_EQ(std::count(flags.begin(), flags.begin() + cloud_size, 1), 0);
  EXPECT_EQ(std::count(flags.begin() + cloud_size, flags.end(), 0), 0);
}

// A sign that is read from afar: small, dense, apart, and a surface all the same.
TEST(FindOutliers, KeepsSmallPiecesOfSurface) {
  std::vector<Vec3> points = random_square(cloud_size, 15);
  for (const Vec3& p : random_square(60, 16)) points.push_back({2 + 0.08 * p.x, 0.5, 0.08 * p.y});
  const std::vector<std::uint8_t> flags = find_outliers(points);
  EXPECT_EQ(std::count(flags.begin() + cloud_size, flags.end(), 1), 0);
}

TEST(FindOutliers, GivesDuplicatesTheSameFate) {
  Spoiled cloud = spoiled_cube(0.0025, 17);
  const std::vector<std::uint8_t> once = find_outliers(cloud.points);
  const std::size_t n = cloud.points.size();
  for (std::size_t i = 0; i < n; i += 3) cloud.points.push_back(cloud.points[i]);
  const std::vector<std::uint8_t> flags = find_outliers(cloud.points);
  EXPECT_EQ(std::vector(flags.begin(), flags.begin() + static_cast<std::ptrdiff_t>(n)), once);
  for (std::size_t i = n; i < flags.size(); ++i) EXPECT_EQ(flags[i], once[3 * (i - n)]);
}

TEST(FindOutliers, IsMoreOrLessStrictAsAsked) {
  const Spoiled cloud = spoiled_cube(0.0025, 18);
  const auto flagged = [&](double tolerance) {
    return share_flagged(find_outliers(cloud.points, {.tolerance = tolerance}));
  };
  EXPECT_LT(flagged(2), flagged(1));
  EXPECT_GT(flagged(0.5), flagged(1));
}

TEST(FindOutliers, NamesTheOptionThatIsOutOfRange) {
  const std::vector<Vec3> points = random_square(100, 19);
  for (const double bad : {0.0, 0.09, 11.0, -1.0, not_a_number}) {
    const std::string message =
        invalid_argument_of([&] { (void)find_outliers(points, {.tolerance = bad}); });
    EXPECT_THAT(message, testing::StartsWith("outliers.tolerance must be in [0.1, 10], got "));
  }
}

}  // namespace
}  // namespace deburr

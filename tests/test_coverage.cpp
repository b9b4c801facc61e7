// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deburr/metrics.hpp"
#include "support/compare.hpp"
#include "support/meshes.hpp"
#include "surface_sampler.hpp"

namespace deburr {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The mean distance from a place in a unit square to its corner is (sqrt 2 + asinh 1) / 3.
TEST(SurfaceCoverage, OfOnePointIsThatDerivedByHand) {
  const std::vector<Vec3> corner{{0, 0, 0}};
  const DistanceError error = surface_coverage(corner, square_mesh());
  EXPECT_EQ(error.count, CoverageOptions{}.samples);
  EXPECT_EQ(error.diagonal, std::sqrt(2.0));
  // Five standard errors of the mean of 100,000: the standard deviation is 0.285.
  EXPECT_NEAR(error.mean, (std::sqrt(2.0) + std::asinh(1.0)) / 3, 0.0045);
  EXPECT_NEAR(error.rms, std::sqrt(2.0 / 3), 0.0045);
  EXPECT_LT(error.maximum, std::sqrt(2.0));
  EXPECT_GT(error.maximum, 1.4);
}

// By cell of the grid the mean is that to the corner of a square of half the spacing.
TEST(SurfaceCoverage, OfAGridIsAFractionOfTheSpacing) {
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) points.push_back({(i + 0.5) / 20, (j + 0.5) / 20, 0});
  }
  const DistanceError error = surface_coverage(points, square_mesh());
  EXPECT_NEAR(error.mean, (std::sqrt(2.0) + std::asinh(1.0)) / 6 / 20, 0.0045 / 40);
  EXPECT_NEAR(mean_spacing(square_mesh(), points.size()), 1.0 / 20, 1e-15);
}

// Half of the square is bare: its places are up to 0.5 away, the 95th percentile 0.45.
TEST(SurfaceCoverage, SeesWhatIsBare) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 50; ++i) {
    for (int j = 0; j <= 100; ++j) points.push_back({0.01 * i, 0.01 * j, 0});
  }
  EXPECT_NEAR(surface_coverage(points, square_mesh()).percentile_95, 0.45, 0.005);
}

TEST(SurfaceCoverage, EqualsBruteForceOverItsSamples) {
  std::vector<Vec3> points = random_points(40, 1);
  points.push_back({nan, 0.5, 0.5});
  const TriangleMesh mesh = random_mesh(30, 2);
  const SurfaceSampler sampler(mesh);
  Random random(3);
  std::vector<double> distances(500);
  for (double& distance : distances) {
    const Vec3 place = sampler.draw(random);
    distance = std::numeric_limits<double>::infinity();
    for (const Vec3& p : points) distance = std::fmin(distance, norm(p - place));
  }
  std::ranges::sort(distances);
  const DistanceError error = surface_coverage(points, mesh, {.samples = 500, .seed = 3});
  EXPECT_EQ(error.count, 500U);
  EXPECT_NEAR(error.mean, mean_of(500, [&](std::size_t i) { return distances[i]; }), 1e-15);
  EXPECT_EQ(error.percentile_95, distances[474]);  // 475 of 500
  EXPECT_EQ(error.maximum, distances[499]);
}

TEST(SurfaceCoverage, DependsOnTheSeedAloneAndNotOnThreads) {
  const std::vector<Vec3> points = random_points(300, 4);
  const DistanceError one = surface_coverage(points, cube_mesh(), {.seed = 1}, {.threads = 1});
  const DistanceError three = surface_coverage(points, cube_mesh(), {.seed = 1}, {.threads = 3});
  EXPECT_EQ(one.mean, three.mean);
  EXPECT_EQ(one.percentile_95, three.percentile_95);
  EXPECT_NE(surface_coverage(points, cube_mesh(), {.seed = 2}).mean, one.mean);
}

TEST(SurfaceCoverage, MeasuresNothingWithoutPointsOrArea) {
  const std::vector<Vec3> none{{nan, 0, 0}};
  EXPECT_EQ(surface_coverage(none, cube_mesh()).count, 0U);
  const std::vector<Vec3> one{{0, 0, 0}};
  EXPECT_EQ(surface_coverage(one, {{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}}).count, 0U);
  const DistanceError zero = surface_coverage(one, cube_mesh(), {.samples = 0});
  EXPECT_EQ(zero.count, 0U);
  EXPECT_EQ(zero.mean, 0);
  EXPECT_EQ(invalid_argument_of([&] { (void)surface_coverage(one, {}); }),
            "surface has no triangles");
}

TEST(MeanSpacing, IsTheSideOfThePatchOfAPoint) {
  EXPECT_DOUBLE_EQ(mean_spacing(cube_mesh(), 600), 0.1);
  EXPECT_EQ(mean_spacing(cube_mesh(), 0), 0);
  EXPECT_EQ(invalid_argument_of([] { (void)mean_spacing({}, 1); }), "surface has no triangles");
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <numeric>

#include "deburr/denoise.hpp"
#include "deburr/noise.hpp"
#include "deburr/outliers.hpp"
#include "near_duplicates.hpp"
#include "spatial_order.hpp"
#include "support/compare.hpp"
#include "support/outlier_clouds.hpp"
#include "support/shapes.hpp"
#include "working_set.hpp"

namespace deburr {
namespace {

constexpr std::size_t cloud_size = 4000;
const double spacing = std::sqrt(24.0 / cloud_size);

const Spoiled& cube_with_outliers() {
  static const Spoiled made = spoil(cube(cloud_size, 1).points, spacing, 0.02, 2, distance_to_cube);
  return made;
}

/// Adds a copy of three points in ten, `offset` away. Copy k is one of point k * 10 / 3.
std::vector<Vec3> with_copies(std::vector<Vec3> points, double offset) {
  const std::size_t n = points.size();
  const std::vector<Vec3> directions = random_directions(n, 3);
  for (std::size_t k = 0; 10 * k / 3 < n; ++k) {
    const Vec3 from = points[10 * k / 3];
    points.push_back(from + offset * directions[k]);
  }
  return points;
}

std::vector<Vec3> in_spatial_order(const std::vector<Vec3>& points) {
  return gather<Vec3>(points, spatial_order(points, {}));
}

TEST(NearDuplicates, AreThoseWithinAThousandthOfTheSpacing) {
  const std::vector<Vec3>& points = cube_with_outliers().points;
  for (const double offset : {1e-9, 1e-5, 3e-4}) {
    const std::vector<Vec3> all = in_spatial_order(with_copies(points, offset * spacing));
    const std::vector<std::uint32_t> standing = find_near_duplicates(all, {});
    ASSERT_EQ(standing.size(), all.size()) << offset;
    std::size_t merged = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_LE(standing[i], i);
      ASSERT_EQ(standing[standing[i]], standing[i]);
      ASSERT_LE(norm(all[i] - all[standing[i]]), 2e-3 * spacing);
      merged += standing[i] != i ? 1 : 0;
    }
    EXPECT_EQ(merged, all.size() - points.size()) << offset;
  }
}

TEST(NearDuplicates, AreNoneWhereFewPointsAreNearByChance) {
  EXPECT_TRUE(find_near_duplicates(in_spatial_order(cube_with_outliers().points), {}).empty());
  EXPECT_TRUE(find_near_duplicates(in_spatial_order(plane_grid(60).points), {}).empty());
  const std::vector<Vec3> apart = with_copies(cube_with_outliers().points, 0.02 * spacing);
  EXPECT_TRUE(find_near_duplicates(in_spatial_order(apart), {}).empty());
  EXPECT_TRUE(find_near_duplicates({}, {}).empty());
  EXPECT_TRUE(find_near_duplicates(random_points(63, 4), {}).empty());
}

// A third of the points, in a piece a thousand times as small, are all different.
TEST(NearDuplicates, DependOnTheDensityThere) {
  std::vector<Vec3> points = sphere(cloud_size, 5).points;
  for (const Vec3& p : sphere(cloud_size / 2, 6).points) points.push_back(1e-3 * p);
  EXPECT_TRUE(find_near_duplicates(in_spatial_order(points), {}).empty());
}

// Points along a line, each near the next one.
TEST(NearDuplicates, DoNotMakeOnePointOfAChain) {
  std::vector<Vec3> points = cube(cloud_size, 7).points;
  for (int i = 0; i < 100; ++i) points.push_back({3e-5 * i, 0.5, 0.5});
  const std::vector<Vec3> all = in_spatial_order(points);
  const std::vector<std::uint32_t> standing = find_near_duplicates(all, {});
  for (std::size_t i = 0; i < standing.size(); ++i) {
    ASSERT_LE(norm(all[i] - all[standing[i]]), 2e-3 * spacing);
  }
}

TEST(NearDuplicates, GetTheResultOfTheOneThatStandsForThem) {
  PointCloud once;
  once.points = cube_with_outliers().points;
  PointCloud twice;
  twice.points = with_copies(once.points, 1e-9 * spacing);
  const DenoiseResult plain = denoise(once);
  const DenoiseResult result = denoise(twice);
  const std::size_t n = once.size();
  EXPECT_EQ(result.report.duplicates, twice.size() - n);
  EXPECT_NEAR(result.report.noise, plain.report.noise, 1e-6 * spacing);
  EXPECT_NEAR(result.report.spacing, plain.report.spacing, 1e-6 * spacing);
  std::size_t others = 0;
  for (std::size_t i = 0; i < twice.size(); ++i) {
    const std::size_t of = i < n ? i : 10 * (i - n) / 3;
    others += result.labels[i] != plain.labels[of] ? 1 : 0;
    EXPECT_EQ(result.outliers[i], plain.outliers[of]);
    EXPECT_LE(norm(result.cloud.points[i] - plain.cloud.points[of]), 1e-5 * spacing);
  }
  EXPECT_EQ(others, 0U);
}

TEST(NearDuplicates, ChangeNoFigureOfOutliersAndNoise) {
  const std::vector<Vec3>& points = cube_with_outliers().points;
  // A copy of every point, as rounding makes it.
  std::vector<Vec3> all = points;
  for (const Vec3& p : points) all.push_back(p + 1e-8 * spacing * Vec3{1, 1, -1});
  const std::vector<std::uint8_t> once = find_outliers(points);
  const std::vector<std::uint8_t> twice = find_outliers(all);
  const auto middle = twice.begin() + static_cast<std::ptrdiff_t>(points.size());
  EXPECT_EQ(std::vector(twice.begin(), middle), once);
  EXPECT_EQ(std::vector(middle, twice.end()), once);
  const double noise = estimate_noise(points);
  EXPECT_NEAR(estimate_noise(all), noise, 1e-6 * noise);
}

TEST(NearDuplicates, KeepTheNormalThatOneOfThemHas) {
  PointCloud cloud;
  cloud.points = with_copies(plane_grid(20).points, 1e-7);
  cloud.normals.assign(cloud.size(), {0, 0, 1});
  std::fill(cloud.normals.begin(), cloud.normals.begin() + 400, Vec3{});
  const WorkingSet set = make_working_set(cloud, {}, {});
  ASSERT_EQ(set.points.size(), 400U);
  ASSERT_EQ(set.normals.size(), 400U);
  EXPECT_EQ(set.duplicates, cloud.size() - 400);
  for (std::size_t i = 400; i < cloud.size(); ++i) {
    EXPECT_EQ(set.normals[set.slot[i]], (Vec3{0, 0, 1}));
    EXPECT_EQ(set.slot[i], set.slot[10 * (i - 400) / 3]);
  }
  EXPECT_EQ(std::ranges::count(set.normals, Vec3{}),
            400 - static_cast<std::ptrdiff_t>(cloud.size() - 400));
}

// The published method works on every point.
TEST(NearDuplicates, StayForThePublishedMethod) {
  PointCloud cloud;
  cloud.points = with_copies(cube_with_outliers().points, 1e-9 * spacing);
  const DenoiseResult result =
      denoise(cloud, {.method = Method::Yadav2018, .yadav2018 = {.rounds = 1}});
  EXPECT_EQ(result.report.duplicates, 0U);
}

}  // namespace
}  // namespace deburr

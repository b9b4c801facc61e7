// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "deburr/error.hpp"
#include "deburr/neighborhoods.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;

std::vector<std::uint32_t> brute_force(Points points, std::size_t i, const NeighborOptions& o) {
  std::vector<std::pair<double, std::uint32_t>> all;
  for (std::uint32_t j = 0; j < points.size(); ++j) {
    const double d = squared_norm(points[j] - points[i]);
    if (j != i && (o.radius == 0 || d <= o.radius * o.radius)) all.emplace_back(d, j);
  }
  std::sort(all.begin(), all.end());
  if (o.max_count > 0 && all.size() > o.max_count) all.resize(o.max_count);
  std::vector<std::uint32_t> indices;
  indices.reserve(all.size());
  for (const auto& [d, j] : all) indices.push_back(j);
  return indices;
}

void expect_equals_brute_force(Points points, const NeighborOptions& options) {
  const Neighborhoods found = find_neighbors(points, options);
  ASSERT_EQ(found.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::vector<std::uint32_t> expected = brute_force(points, i, options);
    ASSERT_TRUE(std::ranges::equal(found[i], expected)) << "point " << i;
  }
}

TEST(FindNeighbors, EqualsBruteForceOnRandomPoints) {
  const auto points = random_points(700, 1);
  expect_equals_brute_force(points, {.max_count = 12});
  expect_equals_brute_force(points, {.radius = 0.15});
  expect_equals_brute_force(points, {.max_count = 9, .radius = 0.12});
}

TEST(FindNeighbors, BreaksTiesByIndexOnGridsWithDuplicates) {
  const auto points = grid_points(500, 2);
  expect_equals_brute_force(points, {.max_count = 7});
  expect_equals_brute_force(points, {.radius = 1});  // the radius itself is a distance: inclusive
  expect_equals_brute_force(points, {.max_count = 40, .radius = 2});
}

TEST(FindNeighbors, GivesAllOthersWhenThereAreFewerThanAsked) {
  for (std::size_t n = 0; n < 6; ++n) {
    expect_equals_brute_force(random_points(n, 3), {.max_count = 10});
  }
}

TEST(FindNeighbors, FindsDuplicatesAtDistanceZero) {
  const std::vector<Vec3> points(5, Vec3{1, 2, 3});
  const Neighborhoods found = find_neighbors(points, {.max_count = 3});
  EXPECT_THAT(found[0], ElementsAre(1, 2, 3));
  EXPECT_THAT(found[4], ElementsAre(0, 1, 2));
}

// Each search would read all points if duplicates were not split by index: 4e10 steps.
TEST(FindNeighbors, EndsOnManyDuplicates) {
  const std::vector<Vec3> points(200000, Vec3{1, 2, 3});
  const Neighborhoods found = find_neighbors(points, {.max_count = 2});
  EXPECT_THAT(found[0], ElementsAre(1, 2));
  EXPECT_THAT(found[199999], ElementsAre(0, 1));
}

TEST(FindNeighbors, RefusesMorePairsThanMemoryHolds) {
  const std::vector<Vec3> points(150000, Vec3{1, 2, 3});
  EXPECT_THROW((void)find_neighbors(points, {.radius = 1}), DataError);
}

TEST(FindNeighbors, IsTheSameForAnyNumberOfThreads) {
  const auto points = random_points(5000, 4);
  const Neighborhoods one = find_neighbors(points, {.radius = 0.1}, {.threads = 1});
  for (const int threads : {2, 3, 7}) {
    const Neighborhoods other = find_neighbors(points, {.radius = 0.1}, {.threads = threads});
    ASSERT_EQ(other.pair_count(), one.pair_count());
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_TRUE(std::ranges::equal(one[i], other[i]));
    }
  }
}

TEST(FindNeighbors, KeepsExactAtLargeOffsetsAndSmallScales) {
  auto points = random_points(300, 5);
  for (Vec3& p : points) p = {1e7 + p.x * 1e-2, -1e7 + p.y * 1e-2, p.z * 1e-2};
  expect_equals_brute_force(points, {.max_count = 12});
  points = random_points(300, 6);
  for (Vec3& p : points) p = 1e-9 * p;
  expect_equals_brute_force(points, {.radius = 2e-10});
}

TEST(FindNeighbors, NamesTheWrongOption) {
  const std::vector<Vec3> points(3);
  const auto message = [&](const NeighborOptions& options) -> std::string {
    try {
      (void)find_neighbors(points, options);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message({.radius = -1}), "neighbors.radius must be finite and >= 0, got -1");
  EXPECT_THAT(message({}), testing::HasSubstr("must not both be 0"));
  EXPECT_THAT(message({.radius = std::numeric_limits<double>::quiet_NaN()}),
              testing::HasSubstr("neighbors.radius"));
}

TEST(FindNeighbors, NamesThePointThatIsNotFinite) {
  std::vector<Vec3> points(3);
  points[2].y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)find_neighbors(points, {.max_count = 1}), std::invalid_argument);
}

TEST(FindNeighbors, StopsWhenCancelled) {
  const auto points = random_points(5000, 7);
  const Execution execution{.cancelled = [] { return true; }};
  EXPECT_THROW((void)find_neighbors(points, {.max_count = 5}, execution), Cancelled);
}

TEST(Neighborhoods, RefusesOffsetsThatDoNotPartition) {
  EXPECT_THROW(Neighborhoods({0, 2}, {1}), std::invalid_argument);
  EXPECT_THROW(Neighborhoods({0, 2, 1, 3}, {1, 2, 0}), std::invalid_argument);
  EXPECT_EQ(Neighborhoods({0, 1, 2}, {1, 0}).size(), 2U);
}

TEST(MeanNeighborDistance, AveragesOverAllPairs) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}};
  // Nearest distances 1, 1, 2.
  EXPECT_DOUBLE_EQ(mean_neighbor_distance(points, find_neighbors(points, {.max_count = 1})),
                   4.0 / 3);
  EXPECT_EQ(mean_neighbor_distance(points, find_neighbors(points, {.radius = 0.5})), 0);
  EXPECT_THROW((void)mean_neighbor_distance(points, Neighborhoods{}), std::invalid_argument);
}

}  // namespace
}  // namespace deburr

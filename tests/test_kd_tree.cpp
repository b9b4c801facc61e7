// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "kd_tree.hpp"
#include "support/shapes.hpp"

// Searches from places that are no points of the tree; those from its own points are tested
// through find_neighbors.

namespace deburr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<Found> brute_force(Points points, const Vec3& at, std::size_t count,
                               double squared_radius) {
  std::vector<Found> all;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const double d = squared_norm(points[i] - at);
    if (d <= squared_radius) all.push_back({d, i});
  }
  std::sort(all.begin(), all.end());
  if (all.size() > count) all.resize(count);
  return all;
}

void expect_same(const std::vector<Found>& found, const std::vector<Found>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    ASSERT_EQ(found[k].index, expected[k].index) << k;
    ASSERT_EQ(found[k].squared_distance, expected[k].squared_distance) << k;
  }
}

/// Places among the points, at some of them, and far away.
std::vector<Vec3> places_for(const std::vector<Vec3>& points) {
  std::vector<Vec3> places = random_points(200, 7);
  places.insert(places.end(), points.begin(), points.begin() + 50);
  for (const Vec3& p : random_points(20, 8)) places.push_back(100 * p);
  for (const Vec3& p : grid_points(50, 9)) places.push_back(p + Vec3{0.5, 0, 0.5});
  return places;
}

TEST(KdTree, FindsFromAnyPlaceWhatBruteForceFinds) {
  // On the grid many points are at the same distance, and some at the same place.
  for (const auto& points : {random_points(700, 1), grid_points(700, 2), random_points(60, 3)}) {
    const KdTree tree(points);
    std::vector<Found> found;
    for (const Vec3& at : places_for(points)) {
      const Found nearest = tree.nearest_to(at);
      expect_same({nearest}, brute_force(points, at, 1, infinity));
      tree.nearest_to(at, 9, infinity, found);
      expect_same(found, brute_force(points, at, 9, infinity));
      tree.nearest_to(at, 5, 0.25, found);
      expect_same(found, brute_force(points, at, 5, 0.25));
      tree.within_of(at, 0.25, found);
      expect_same(found, brute_force(points, at, points.size(), 0.25));
    }
  }
}

TEST(KdTree, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Vec3> points = random_points(20000, 4);
  const KdTree one(points);
  for (const int threads : {1, 2, 3, 7}) {
    const KdTree many(points, {.threads = threads});
    EXPECT_EQ(many.order(), one.order());
    std::vector<Found> found;
    for (std::uint32_t i = 17 * static_cast<std::uint32_t>(threads); i < points.size(); i += 400) {
      many.nearest_to(points[i], 400, infinity, found);
      expect_same(found, brute_force(points, points[i], 400, infinity));
    }
  }
}

TEST(KdTree, RunsHoldEveryPointWithin) {
  for (const auto& points : {random_points(700, 5), grid_points(700, 6), random_points(5, 7)}) {
    const KdTree tree(points);
    std::vector<KdTree::Run> runs;
    for (const Vec3& at : places_for(random_points(50, 8))) {
      tree.runs_within(at, 0.25, runs);
      std::vector<std::uint32_t> there;
      for (const auto& [begin, end] : runs) {
        ASSERT_LT(begin, end);
        for (std::uint32_t k = begin; k < end; ++k) {
          EXPECT_EQ(tree.along_leaves()[k], points[tree.order()[k]]);
          there.push_back(tree.order()[k]);
        }
      }
      std::sort(there.begin(), there.end());
      EXPECT_EQ(std::unique(there.begin(), there.end()), there.end());
      for (const Found& f : brute_force(points, at, points.size(), 0.25)) {
        EXPECT_TRUE(std::binary_search(there.begin(), there.end(), f.index));
      }
    }
  }
}

TEST(KdTree, FindsNothingInAnEmptyCloud) {
  const KdTree tree(Points{});
  std::vector<Found> found{{1, 1}};
  tree.nearest_to({0, 0, 0}, 3, infinity, found);
  EXPECT_TRUE(found.empty());
  found = {{1, 1}};
  tree.within_of({0, 0, 0}, infinity, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace deburr

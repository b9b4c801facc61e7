// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "cell_grid.hpp"
#include "deburr/neighborhoods.hpp"
#include "kd_tree.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

/// Compares the grid with brute force, at every point.
void expect_exact(const std::vector<Vec3>& points, double radius, std::size_t max_count = 0) {
  const auto grid = CellGrid::make(points, radius, 0, {});
  ASSERT_TRUE(grid.has_value());
  ASSERT_EQ(grid->size(), points.size());
  std::vector<std::size_t> counts(points.size());
  grid->count(0, points.size(), counts.data());
  std::vector<std::uint32_t> indices(points.size());
  for (std::size_t slot = 0; slot < points.size(); ++slot) {
    const std::uint32_t i = grid->index(slot);
    std::vector<Found> expected;
    for (std::uint32_t j = 0; j < points.size(); ++j) {
      const double squared = squared_norm(points[j] - points[i]);
      if (j != i && squared <= radius * radius) expected.push_back({squared, j});
    }
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(counts[slot], expected.size());
    std::array<Found, 6> six;
    grid->nearest(slot, slot + 1, six.size(), six.data());
    for (std::size_t k = 0; k < six.size(); ++k) {
      const bool there = k < expected.size();
      ASSERT_EQ(std::isfinite(six[k].squared_distance), there);
      if (there) {
        ASSERT_EQ(six[k].index, expected[k].index) << k;
      }
    }
    if (max_count > 0) counts[slot] = std::min(counts[slot], max_count);
    const CellGrid::Query query{static_cast<std::uint32_t>(slot),
                                static_cast<std::uint32_t>(counts[slot]), indices.data()};
    grid->find({&query, 1});
    for (std::size_t k = 0; k < counts[slot]; ++k) ASSERT_EQ(indices[k], expected[k].index) << k;
  }
}

/// A square sheet of random points, `thickness` high.
std::vector<Vec3> sheet(std::size_t n, double thickness, unsigned seed) {
  std::vector<Vec3> points = random_points(n, seed);
  for (Vec3& p : points) p.z *= thickness;
  return points;
}

TEST(CellGrid, FindsWhatBruteForceFinds) {
  expect_exact(random_points(600, 1), 0.3);
  expect_exact(random_points(600, 2), 0.1);
  expect_exact(random_points(600, 13), 0.5);  // too many to be ranked
  expect_exact(random_points(600, 14), 0.5, 50);
  expect_exact(sheet(800, 0.02, 3), 0.12);
  expect_exact(sheet(800, 0.02, 3), 0.12, 17);
  expect_exact(sheet(800, 0, 4), 0.12, 3);
}

TEST(CellGrid, FindsNeighborsAtTheVeryRadiusInOrderOfIndex) {
  // Integer places, many of them twice; borders of cells are close to points and to the radius.
  expect_exact(grid_points(500, 5), 1);
  expect_exact(grid_points(500, 6), 2, 40);
  std::vector<Vec3> points = grid_points(400, 7);
  for (Vec3& p : points) p = 0.1 * p;
  expect_exact(points, 0.1);
  expect_exact(points, 0.30000000000000004);
}

TEST(CellGrid, FindsWhatIsInOnePlaceAndAllThatThereIs) {
  expect_exact(std::vector<Vec3>(60, Vec3{1, 2, 3}), 0.5);
  expect_exact(random_points(90, 8), 50);
  expect_exact({{1, 2, 3}}, 0.5);
}

TEST(CellGrid, KeepsExactAtLargeOffsetsAndAnyScale) {
  std::vector<Vec3> points = random_points(400, 9);
  for (Vec3& p : points) p = {5e8 + p.x, -5e8 + p.y, 1e-3 * p.z};
  expect_exact(points, 0.25);
  for (const double scale : {1e-90, 1e90}) {
    points = grid_points(300, 10);
    for (Vec3& p : points) p = scale * p;
    expect_exact(points, scale);
  }
}

TEST(CellGrid, FindsWhatIsNearAnyPlace) {
  const std::vector<Vec3> points = sheet(800, 0.02, 15);
  constexpr double radius = 0.12;
  const auto grid = CellGrid::make(points, radius, 0, {});
  ASSERT_TRUE(grid.has_value());
  std::vector<Found> found;
  std::size_t some = 0;
  for (const Vec3& p : random_points(300, 16)) {
    const Vec3 at{1.5 * p.x - 0.25, 1.5 * p.y - 0.25, 0.6 * p.z - 0.3};  // also beside the grid
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (squared_norm(points[i] - at) <= radius * radius) expected.push_back(i);
    }
    grid->within_of(at, found);
    std::vector<std::uint32_t> indices;
    for (const Found& f : found) {
      EXPECT_EQ(f.squared_distance, squared_norm(points[f.index] - at));
      indices.push_back(f.index);
    }
    std::ranges::sort(indices);
    ASSERT_EQ(indices, expected);
    some += expected.empty() ? 0U : 1U;
  }
  EXPECT_GT(some, 50);
  grid->within_of({1e6, -1e6, 1e6}, found);
  EXPECT_TRUE(found.empty());
}

TEST(CellGrid, LeavesToTheTreeWhatWouldNotPay) {
  const std::vector<Vec3> points = random_points(500, 11);
  EXPECT_FALSE(CellGrid::make(points, 0.001, 0, {}));  // mostly empty cells
  EXPECT_FALSE(CellGrid::make(points, 1e-200, 0, {}));
  EXPECT_FALSE(CellGrid::make(points, 1e200, 0, {}));
  EXPECT_FALSE(CellGrid::make(Points{}, 1, 0, {}));
  // Within the radius are all, and two are wanted.
  EXPECT_FALSE(CellGrid::make(points, 5, 2, {}));
  EXPECT_TRUE(CellGrid::make(points, 5, 200, {}));
  // As many pairs as are refused.
  EXPECT_FALSE(CellGrid::make(std::vector<Vec3>(70000, Vec3{1, 2, 3}), 1, 0, {}));
  const std::vector<Vec3> far{{-1e308, 0, 0}, {1e308, 0, 0}, {0, 0, 0}};
  EXPECT_FALSE(CellGrid::make(far, 1, 0, {}));
}

TEST(FindNeighbors, IsTheSameByGridAndByTree) {
  // One point far away makes the grid too large.
  std::vector<Vec3> points = sheet(3000, 0.05, 12);
  ASSERT_TRUE(CellGrid::make(points, 0.08, 0, {}));
  const Neighborhoods by_grid = find_neighbors(points, {.radius = 0.08});
  const Neighborhoods nearest = find_neighbors(points, {.max_count = 20, .radius = 0.08});
  points.push_back({1e6, 1e6, 1e6});
  ASSERT_FALSE(CellGrid::make(points, 0.08, 0, {}));
  const Neighborhoods by_tree = find_neighbors(points, {.radius = 0.08});
  const Neighborhoods nearest_by_tree = find_neighbors(points, {.max_count = 20, .radius = 0.08});
  ASSERT_GT(by_grid.pair_count(), 10 * points.size());
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    ASSERT_TRUE(std::ranges::equal(by_grid[i], by_tree[i])) << i;
    ASSERT_TRUE(std::ranges::equal(nearest[i], nearest_by_tree[i])) << i;
  }
}

}  // namespace
}  // namespace deburr

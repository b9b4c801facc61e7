// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "box.hpp"
#include "support/shapes.hpp"
#include "tree_layout.hpp"

namespace deburr {
namespace {

constexpr std::uint32_t most = 16;

/// The ranges of a node and of all below it; checks that children split their parent.
void expect_whole(const TreeLayout& layout, std::uint32_t self, std::size_t& seen) {
  ++seen;
  const auto& [begin, end, right] = layout.ranges.at(self);
  ASSERT_LT(begin, end);
  if (right == 0) {
    EXPECT_LE(end - begin, most);
    return;
  }
  EXPECT_GT(end - begin, most);
  const auto& left_child = layout.ranges.at(self + 1);
  const auto& right_child = layout.ranges.at(right);
  EXPECT_EQ(left_child.begin, begin);
  EXPECT_EQ(left_child.end, right_child.begin);
  EXPECT_EQ(right_child.end, end);
  expect_whole(layout, self + 1, seen);
  expect_whole(layout, right, seen);
}

void expect_tree_over(const std::vector<Vec3>& points) {
  const TreeLayout layout = lay_out_tree(points, most, {});
  std::vector<std::uint32_t> sorted = layout.order;
  std::ranges::sort(sorted);
  std::vector<std::uint32_t> all(points.size());
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(sorted, all);
  EXPECT_EQ(layout.ranges.at(0).end, points.size());
  std::size_t seen = 0;
  expect_whole(layout, 0, seen);
  EXPECT_EQ(seen, layout.ranges.size());
}

/// Places of the points of each leaf.
std::set<std::set<std::tuple<double, double, double>>> leaves(const std::vector<Vec3>& points) {
  const TreeLayout layout = lay_out_tree(points, most, {});
  std::set<std::set<std::tuple<double, double, double>>> places;
  for (const auto& [begin, end, right] : layout.ranges) {
    if (right != 0) continue;
    std::set<std::tuple<double, double, double>> leaf;
    for (std::uint32_t k = begin; k < end; ++k) {
      const Vec3& p = points[layout.order[k]];
      leaf.emplace(p.x, p.y, p.z);
    }
    places.insert(leaf);
  }
  return places;
}

/// Mean half diagonal of the boxes around the leaves.
double mean_leaf(const std::vector<Vec3>& points) {
  const TreeLayout layout = lay_out_tree(points, most, {});
  double sum = 0;
  double count = 0;
  for (const auto& [begin, end, right] : layout.ranges) {
    if (right != 0) continue;
    Box box;
    for (std::uint32_t k = begin; k < end; ++k) box.add(points[layout.order[k]]);
    sum += norm(half_extent(box));
    ++count;
  }
  return sum / count;
}

TEST(TreeLayout, SplitsAllPoints) {
  expect_tree_over(random_points(5, 1));
  expect_tree_over(random_points(700, 2));
  expect_tree_over(random_points(5000, 3));
  // Many at one place, and all.
  expect_tree_over(grid_points(3000, 4));
  expect_tree_over(std::vector<Vec3>(1000, Vec3{1, 2, 3}));
  std::vector<Vec3> line;
  for (int i = 0; i < 3000; ++i) line.push_back({0, 0.1 * i, 0});
  expect_tree_over(line);
  // Each ten times as far off as the one before.
  std::vector<Vec3> steps;
  for (double x = 1e-150; x < 1e150; x *= 10) steps.push_back({x, 0, -x});
  expect_tree_over(steps);
  EXPECT_TRUE(lay_out_tree(Points{}, most, {}).ranges.empty());
}

TEST(TreeLayout, LeavesDoNotDependOnTheOrderOfPoints) {
  std::vector<Vec3> points = random_points(5000, 5);
  const auto before = leaves(points);
  EXPECT_GT(before.size(), points.size() / most);
  std::ranges::reverse(points);
  std::rotate(points.begin(), points.begin() + 1234, points.end());
  EXPECT_EQ(leaves(points), before);
}

TEST(TreeLayout, SplitsBetweenClumpsThatAreApart) {
  std::vector<Vec3> points = random_points(300, 7);
  for (const Vec3& p : random_points(500, 8)) points.push_back(p + Vec3{0, 100, 0});
  const TreeLayout layout = lay_out_tree(points, most, {});
  EXPECT_EQ(layout.ranges.at(1).end, 300U);
}

TEST(TreeLayout, LeavesAreSmallAlsoFarFromAStrayPoint) {
  std::vector<Vec3> points = random_points(5000, 6);
  const double alone = mean_leaf(points);
  // About as large as cubes with so many points.
  EXPECT_LT(alone, 0.25);
  points.push_back({1e9, 0, 0});
  EXPECT_LT(mean_leaf(points), 1.1 * alone);
}

}  // namespace
}  // namespace deburr

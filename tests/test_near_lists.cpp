// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "deburr/error.hpp"
#include "near_lists.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

void expect_same_lists(const NearLists& lists, const Neighborhoods& near) {
  ASSERT_EQ(lists.size(), near.size());
  std::vector<std::uint32_t> buffer;
  for (std::size_t i = 0; i < near.size(); ++i) {
    ASSERT_TRUE(std::ranges::equal(lists.read(i, buffer), near[i])) << i;
    const auto seen = lists.seen(i / lists.block());
    const auto numbers = lists.read_seen(i, buffer);
    ASSERT_EQ(numbers.size(), near[i].size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      ASSERT_EQ(seen ? (*seen)[numbers[k]] : numbers[k], near[i][k]);
    }
  }
}

/// The lists of any points within a radius, made in both ways, before and after they change places.
void expect_exact(const std::vector<Vec3>& points, double radius, std::uint32_t block) {
  const Neighborhoods near = find_neighbors(points, {.radius = radius});
  NearLists found(points, radius, block, {.threads = 3});
  expect_same_lists(found, near);
  const NearLists copied(near, block, {.threads = 2});
  expect_same_lists(copied, near);
  found.arrange(random_permutation(points.size(), 9), {.threads = 3});
  expect_same_lists(found, near);
}

TEST(NearLists, AreTheNeighborhoods) {
  for (const std::uint32_t block : {1U, 7U, 512U, 4096U}) {
    expect_exact(random_points(1500, 1), 0.12, block);
    expect_exact(grid_points(700, 2), 1, block);  // ties and duplicates
  }
  EXPECT_EQ(NearLists({}, 1, 8, {}).size(), 0U);
}

TEST(NearLists, AreFoundWithTheTreeWhereAGridWouldNotPay) {
  expect_exact(random_points(1500, 3), 1e-3, 64);
}

// Nearly all see more than 16 bits can number, the last block only itself.
TEST(NearLists, KeepPlainListsWhereABlockSeesTooMany) {
  constexpr std::uint32_t many = 66000;
  std::vector<std::size_t> offsets{0};
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < many; ++i) indices.push_back(many - 1 - i);
  offsets.push_back(many);
  indices.insert(indices.end(), {5, 3});
  for (std::uint32_t i = 1; i < many; ++i) offsets.push_back(indices.size());
  const Neighborhoods near(offsets, indices);
  const NearLists lists(near, 100, {});
  EXPECT_FALSE(lists.seen(0));
  EXPECT_TRUE(lists.seen(1));
  expect_same_lists(lists, near);
}

TEST(NearLists, StopWhenCancelled) {
  const std::vector<Vec3> points = random_points(100, 4);
  EXPECT_THROW((void)NearLists(points, 0.2, 8, {.cancelled = [] { return true; }}), Cancelled);
}

}  // namespace
}  // namespace deburr

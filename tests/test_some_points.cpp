// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "some_points.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

using testing::Each;
using testing::ElementsAre;

TEST(SomePoints, FindsWhatIsNearestOfThem) {
  const std::vector<Vec3> points = random_points(400, 1);
  const KdTree tree(points);
  // One in seven: what is nearest in the tree is mostly none of them.
  const SomePoints some(points, tree, [](std::size_t i) { return i % 7 == 3; }, {});
  ASSERT_EQ(some.points().size(), 57);
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (i % 7 != 3) {
      EXPECT_EQ(some.place(i), SomePoints::none);
    } else {
      EXPECT_EQ(some.points()[some.place(i)], points[i]);
    }
  }
  std::vector<Found> found;
  for (const Vec3& at : random_points(20, 2)) {
    std::vector<Found> all;
    for (std::uint32_t i = 0; i < some.points().size(); ++i) {
      all.push_back({squared_norm(some.points()[i] - at), i});
    }
    std::ranges::sort(all, std::less{});
    for (const std::size_t count : {1U, 10U, 57U, 80U}) {
      some.nearest_to(at, count, found);
      ASSERT_EQ(found.size(), std::min<std::size_t>(count, 57));
      for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k].index, all[k].index);
    }
  }
}

TEST(SomePoints, AreGroupedAsTheNodesOfTheTree) {
  const std::vector<Vec3> points = random_points(640, 3);
  const KdTree tree(points);
  const SomePoints all(points, tree);
  const SomePoints right(points, tree, [&](std::size_t i) { return points[i].x > 0.3; }, {});
  // In which of the groups of all points each is.
  std::vector<std::size_t> group_of(points.size());
  const std::vector<std::uint32_t> every = all.groups(20);
  EXPECT_EQ(every.back(), points.size());
  EXPECT_LT(every.size(), 80);  // at least eight points each, in the mean
  for (std::size_t g = 0; g + 1 < every.size(); ++g) {
    ASSERT_LT(every[g], every[g + 1]);
    EXPECT_LE(every[g + 1] - every[g], 20);
    for (std::uint32_t at = every[g]; at < every[g + 1]; ++at) group_of[all.order()[at]] = g;
  }
  std::vector<std::size_t> groups;  // by the places of `right`
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (right.place(i) != SomePoints::none) groups.push_back(group_of[i]);
  }
  const std::vector<std::uint32_t> begins = right.groups(20);
  EXPECT_LT(begins.size(), every.size());
  EXPECT_EQ(begins.front(), 0);
  EXPECT_EQ(begins.back(), right.points().size());
  for (std::size_t g = 0; g + 1 < begins.size(); ++g) {
    ASSERT_LT(begins[g], begins[g + 1]);
    std::vector<std::size_t> members;
    for (std::uint32_t at = begins[g]; at < begins[g + 1]; ++at) {
      members.push_back(groups[right.order()[at]]);
    }
    EXPECT_THAT(members, Each(members[0]));
  }
}

TEST(SomePoints, CanBeNoneOrAll) {
  const std::vector<Vec3> points = random_points(100, 4);
  const KdTree tree(points);
  const SomePoints none(points, tree, [](std::size_t) { return false; }, {});
  EXPECT_TRUE(none.points().empty());
  EXPECT_THAT(none.groups(8), ElementsAre(0));
  std::vector<Found> found;
  none.nearest_to({0, 0, 0}, 3, found);
  EXPECT_TRUE(found.empty());
  const SomePoints all(points, tree, [](std::size_t) { return true; }, {});
  EXPECT_EQ(all.place(42), 42);
  EXPECT_EQ(all.order().size(), 100);
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>

#include "spatial_order.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SpatialOrder, IsAPermutation) {
  std::vector<std::uint32_t> order = spatial_order(grid_points(3000, 1), {});
  std::sort(order.begin(), order.end());
  for (std::uint32_t i = 0; i < 3000; ++i) ASSERT_EQ(order.at(i), i);
}

TEST(SpatialOrder, DependsOnPositionsAlone) {
  const std::vector<Vec3> points = random_points(3000, 2);
  const std::vector<Vec3> shuffled = gather<Vec3>(points, random_permutation(points.size(), 3));
  EXPECT_EQ(gather<Vec3>(points, spatial_order(points, {})),
            gather<Vec3>(shuffled, spatial_order(shuffled, {})));
}

TEST(SpatialOrder, PutsDuplicatesTogetherByIndex) {
  const std::vector<Vec3> points = grid_points(2000, 4);
  const std::vector<std::uint32_t> order = spatial_order(points, {});
  std::size_t changes = 0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (points[order[k]] == points[order[k - 1]]) {
      ASSERT_LT(order[k - 1], order[k]);
    } else {
      ++changes;
    }
  }
  EXPECT_EQ(changes, 4 * 4 * 4 - 1U);
}

// Distinct points that fall into one cell, because a far one makes the cells large.
TEST(SpatialOrder, PutsDuplicatesTogetherWithinACell) {
  std::vector<Vec3> points{{1e300, 0, 0}, {1, 2, 3}, {3, 2, 1}, {2, 2, 2}, {1, 2, 3}, {1, 2, 1}};
  EXPECT_THAT(spatial_order(points, {}), ElementsAre(5, 1, 4, 3, 2, 0));
}

TEST(SpatialOrder, KeepsNeighboursNear) {
  const std::vector<Vec3> points = random_points(10000, 5);
  const std::vector<Vec3> sorted = gather<Vec3>(points, spatial_order(points, {}));
  const double step = mean_of(9999, [&](std::size_t i) { return norm(sorted[i + 1] - sorted[i]); });
  // Two random points are 0.66 apart, neighbours of 10,000 some 0.03.
  EXPECT_LT(step, 0.08);
}

TEST(SpatialOrder, OrdersAlongEachAxis) {
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    const std::vector<Vec3> points{3 * axis, -2 * axis, 7 * axis, 0 * axis};
    EXPECT_THAT(spatial_order(points, {}), ElementsAre(1, 3, 0, 2));
  }
}

TEST(SpatialOrder, HoldsTheWholeRangeOfDoubles) {
  const std::vector<Vec3> points{{1e308, 0, 0}, {-1e308, 0, 0}, {0, 0, 0}, {1e-320, 0, 0}};
  EXPECT_THAT(spatial_order(points, {}), ElementsAre(1, 2, 3, 0));
  const std::vector<Vec3> tiny{{2e-323, 0, 0}, {0, 0, 0}, {1e-323, 0, 0}};
  EXPECT_THAT(spatial_order(tiny, {}), ElementsAre(1, 2, 0));
}

TEST(SpatialOrder, IsDefinedForFewPoints) {
  EXPECT_THAT(spatial_order({}, {}), IsEmpty());
  EXPECT_THAT(spatial_order(std::vector<Vec3>{{1, 2, 3}}, {}), ElementsAre(0));
  EXPECT_THAT(spatial_order(std::vector<Vec3>(3, {1, 2, 3}), {}), ElementsAre(0, 1, 2));
}

TEST(SpatialOrder, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Vec3> points = grid_points(20000, 6);
  const std::vector<std::uint32_t> one = spatial_order(points, {.threads = 1});
  for (const int threads : {2, 3, 7}) EXPECT_EQ(spatial_order(points, {.threads = threads}), one);
}

}  // namespace
}  // namespace deburr

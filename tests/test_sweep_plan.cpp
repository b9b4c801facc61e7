// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "deburr/error.hpp"
#include "lanes.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"
#include "sweep.hpp"

namespace deburr {
namespace {

std::vector<std::uint32_t> by_index(std::uint32_t n) {
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0U);
  return order;
}

NearLists lists_of(const Neighborhoods& near) { return {near, NearLists::usual_block, {}}; }

/// Whether each point comes once, in batches of one to eight, and neighbours in the order given.
void expect_valid(const SweepPlan& plan, const Neighborhoods& near,
                  const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> sorted = plan.order;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(sorted, by_index(static_cast<std::uint32_t>(order.size())));
  std::vector<std::size_t> rank(order.size());
  for (std::size_t at = 0; at < order.size(); ++at) rank[order[at]] = at;
  std::vector<std::size_t> batch_of(order.size());
  std::size_t begin = 0;
  for (std::size_t k = 0; k < plan.ends.size(); ++k) {
    ASSERT_GT(plan.ends[k], begin);
    ASSERT_LE(plan.ends[k], begin + lane_count);
    for (; begin < plan.ends[k]; ++begin) batch_of[plan.order[begin]] = k;
  }
  ASSERT_EQ(begin, order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (const std::uint32_t j : near[i]) {
      ASSERT_EQ(batch_of[i] < batch_of[j], rank[i] < rank[j]);
      ASSERT_NE(batch_of[i], batch_of[j]);
    }
  }
}

TEST(PlanSweep, KeepsTheOrderOfNeighbors) {
  // Of several tiles.
  const auto points = random_points(9500, 1);
  const Neighborhoods near = find_neighbors(points, {.radius = 0.06});
  for (const auto& order : {by_index(9500), random_permutation(9500, 2)}) {
    expect_valid(plan_sweep(lists_of(near), order), near, order);
  }
}

TEST(PlanSweep, FillsBatchesWhereTheOrderAllows) {
  const auto points = random_points(4000, 3);
  const Neighborhoods near = find_neighbors(points, {.radius = 0.08});
  const SweepPlan plan = plan_sweep(lists_of(near), random_permutation(4000, 4));
  EXPECT_LT(plan.ends.size(), 4000 / 4);
  const Neighborhoods none = find_neighbors(points, {.radius = 1e-9});
  EXPECT_EQ(plan_sweep(lists_of(none), by_index(4000)).ends.size(), 500U);
}

TEST(PlanSweep, EndsOnDuplicatesAndOnNothing) {
  const std::vector<Vec3> points(40, Vec3{1, 2, 3});
  const Neighborhoods near = find_neighbors(points, {.radius = 1});
  const std::vector<std::uint32_t> order = random_permutation(40, 5);
  const SweepPlan plan = plan_sweep(lists_of(near), order);
  EXPECT_EQ(plan.order, order);  // all are neighbours: one after the other
  EXPECT_TRUE(plan_sweep(NearLists(), {}).order.empty());
}

TEST(PlanSweep, StopsWhenCancelled) {
  const Neighborhoods near = find_neighbors(random_points(100, 12), {.radius = 0.2});
  const Execution execution{.cancelled = [] { return true; }};
  EXPECT_THROW((void)plan_sweep(lists_of(near), by_index(100), execution), Cancelled);
}

TEST(SweepAlong, HasTheBitsOfTheSweepInPlace) {
  const auto original = random_points(1500, 6);
  const auto normals = tilted(std::vector<Vec3>(1500, Vec3{0, 0, 1}), 0.5, 7);
  const Neighborhoods near = find_neighbors(original, {.radius = 0.15});
  const FeatureOptions features{.rho = 0.8};
  const PositionUpdateOptions options{.position_scale = 0.1,
                                      .normal_scale = 0.5,
                                      .max_move = 0.1,
                                      .offset = Offset::Projected,
                                      .quadric = Quadric::Plain,
                                      .bound = Bound::Reject};
  for (const auto& order : {by_index(1500), random_permutation(1500, 8)}) {
    std::vector<Vec3> expected = original;
    std::vector<Vec3> points = original;
    const FeatureField slow =
        sweep_in_place(original, expected, normals, near, features, options, order);
    NearLists lists = lists_of(near);
    const SweepPlan plan = plan_sweep(lists, order);
    lists.arrange(plan.order, {});
    EXPECT_EQ(sweep_along(plan, original, points, normals, lists, features, options, nullptr, {}),
              slow.label);
    EXPECT_EQ(points, expected);
    EXPECT_NE(points, original);
  }
}

// Once for each way to sweep.
TEST(NextNormals, HaveTheBitsOfTheFilter) {
  const auto original = random_points(1501, 9);
  auto normals = tilted(std::vector<Vec3>(1501, Vec3{0, 0, 1}), 0.5, 10);
  normals[3] = {};
  const Neighborhoods near = find_neighbors(original, {.radius = 0.1});
  const FeatureOptions features{.rho = 0.8};
  const PositionUpdateOptions options{.position_scale = 0.1, .max_move = 0.1};
  NextNormals at_once{.filter = {.rho = 0.8, .tau = 0.2}, .normals = {}};
  NextNormals in_place = at_once;
  const std::vector<Vec3> expected = filter_normals(normals, near, at_once.filter);
  EXPECT_NE(expected, normals);

  std::vector<Vec3> points = original;
  const NearLists lists = lists_of(near);
  const std::vector<Feature> labels = sweep_together(original, original, normals, lists, features,
                                                     options, points, &at_once, {.threads = 2});
  EXPECT_EQ(at_once.normals, expected);
  std::vector<Vec3> without = original;
  EXPECT_EQ(sweep_at_once(original, without, normals, near, features, options).label, labels);
  EXPECT_EQ(points, without);

  points = original;
  without = original;
  const std::vector<std::uint32_t> order = random_permutation(1501, 11);
  sweep_along(plan_sweep(lists, order), original, points, normals, lists, features, options,
              &in_place, {});
  EXPECT_EQ(in_place.normals, expected);
  sweep_in_place(original, without, normals, near, features, options, order);
  EXPECT_EQ(points, without);
}

}  // namespace
}  // namespace deburr

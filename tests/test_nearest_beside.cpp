// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "nearest_beside.hpp"
#include "spatial_order.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

constexpr std::uint32_t none = KdTree::no_point;

std::vector<Found> brute_force(Points points, const Vec3& at, std::size_t count,
                               std::uint32_t excluded) {
  std::vector<Found> all;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (i != excluded) all.push_back({squared_norm(points[i] - at), i});
  }
  const std::size_t kept = std::min(count, all.size());
  std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end());
  all.resize(kept);
  return all;
}

void expect_same(const std::vector<Found>& found, const std::vector<Found>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    ASSERT_EQ(found[k].index, expected[k].index) << k;
    ASSERT_EQ(found[k].squared_distance, expected[k].squared_distance) << k;
  }
}

/// One search after the other, against looking at every point.
void expect_exact(Points points, Points places, std::size_t count,
                  const std::vector<std::uint32_t>& excluded = {}) {
  const KdTree tree(points);
  NearestBeside nearest;
  nearest.expect(places);
  std::vector<Found> found{{1, 1}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::uint32_t out = excluded.empty() ? none : excluded[i];
    nearest.find(tree, places[i], count, found, out);
    expect_same(found, brute_force(points, places[i], count, out));
    if (testing::Test::HasFatalFailure()) FAIL() << "place " << i << ", count " << count;
  }
}

std::vector<Vec3> along_a_curve(const std::vector<Vec3>& points) {
  return gather<Vec3>(points, spatial_order(points, {}));
}

std::vector<std::uint32_t> each_itself(std::size_t size) {
  std::vector<std::uint32_t> indices(size);
  for (std::uint32_t i = 0; i < size; ++i) indices[i] = i;
  return indices;
}

std::vector<Vec3> first(const std::vector<Vec3>& points, std::size_t size) {
  return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(size)};
}

TEST(NearestBeside, FindsOnASurfaceWhatBruteForceFinds) {
  const std::vector<Vec3> points = along_a_curve(random_directions(2000, 1));
  for (const std::size_t count : {1, 2, 19, 24, 33, 100, 150, 300}) {
    expect_exact(points, first(points, 300), count);
    expect_exact(points, first(points, 300), count, each_itself(300));
  }
}

TEST(NearestBeside, FindsInAVolumeWhatBruteForceFinds) {
  const std::vector<Vec3> points = along_a_curve(random_points(3000, 2));
  expect_exact(points, first(points, 200), 100, each_itself(200));
}

TEST(NearestBeside, TiesAreBrokenByIndex) {
  // Whole rings of a grid are at the same distance, and the last one is cut.
  const std::vector<Vec3> plane = along_a_curve(plane_grid(40).points);
  for (const std::size_t count : {7, 24, 33, 100, 150}) {
    expect_exact(plane, first(plane, 200), count, each_itself(200));
    std::vector<Vec3> between = first(plane, 200);
    for (Vec3& p : between) p = p + Vec3{0.5, 0.5, 0.25};
    expect_exact(plane, between, count);
  }
}

TEST(NearestBeside, SquaresThatDifferInTheirLastBitsAreTold) {
  // Points on circles around the middle: their squares are the same but for rounding.
  std::vector<Vec3> points = random_directions(1500, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    Vec3& p = points[i];
    p = (0.01 * static_cast<double>(1 + i / 30)) * p;
  }
  std::vector<Vec3> places(50);
  for (std::size_t i = 0; i < places.size(); ++i) places[i].x = 1e-15 * static_cast<double>(i);
  for (const std::size_t count : {20, 50, 100, 140}) expect_exact(points, places, count);
}

TEST(NearestBeside, ManyPointsAtOnePlace) {
  const std::vector<Vec3> heaps = along_a_curve(grid_points(3000, 4));
  expect_exact(heaps, first(heaps, 100), 24, each_itself(100));
  expect_exact(heaps, first(heaps, 100), 100, each_itself(100));
  // Distinct ones, and one place with more than a ball may hold.
  std::vector<Vec3> points = along_a_curve(random_directions(1000, 5));
  points.insert(points.end(), 4500, points[40]);
  expect_exact(points, first(points, 100), 100, each_itself(100));
}

TEST(NearestBeside, JumpsAndChangesOfDensity) {
  const std::vector<Vec3> fine = random_directions(1200, 6);
  std::vector<Vec3> points;
  for (const Vec3& p : fine) points.push_back(0.01 * p);
  for (const Vec3& p : random_directions(400, 7)) points.push_back(p);
  for (const Vec3& p : random_directions(300, 8)) points.push_back(100 * p);
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < 100; ++i) {
    places.push_back(points[i]);
    if (i % 7 == 0) places.push_back(points[1200 + i]);
    if (i % 10 == 0) places.push_back(points[1600 + i]);
    if (i % 25 == 0) places.push_back({1e8, -1e9, 3});
  }
  for (const std::size_t count : {24, 100}) expect_exact(points, places, count);
}

TEST(NearestBeside, FewerPointsThanWanted) {
  for (const std::size_t size : {0, 1, 2, 99, 100, 101, 102, 130}) {
    const std::vector<Vec3> points = along_a_curve(random_directions(size, 9));
    expect_exact(points, points, 100);
    expect_exact(points, points, 100, each_itself(size));
  }
  const std::vector<Vec3> points = random_directions(10, 9);
  expect_exact(points, points, 0);
  expect_exact({}, points, 3);
}

TEST(NearestBeside, AnyPlaceAndUnit) {
  const std::vector<Vec3> points = along_a_curve(random_directions(800, 10));
  for (const double scale : {1e-170, 3e-162, 1e-161, 1e-160, 1e-155, 1e-6, 1e6, 1e100, 1e155}) {
    std::vector<Vec3> scaled = points;
    for (Vec3& p : scaled) p = scale * p;
    expect_exact(scaled, first(scaled, 60), 100, each_itself(60));
  }
  for (const double offset : {1e6, 1e12, 1e15}) {  // rounding makes ties and duplicates
    std::vector<Vec3> moved = points;
    for (Vec3& p : moved) p = p + Vec3{offset, -offset, offset};
    expect_exact(moved, first(moved, 60), 100, each_itself(60));
  }
}

TEST(NearestBeside, NeitherBlocksNorExpectationsMatter) {
  const std::vector<Vec3> points = along_a_curve(random_directions(2000, 11));
  const KdTree tree(points);
  const auto all = [&](std::size_t block, Points expected, std::size_t step) {
    std::vector<Found> together;
    NearestBeside nearest;
    std::vector<Found> found;
    for (std::size_t i = 0; i < 600; i += step) {
      if (i % block == 0) {
        nearest = {};
        if (!expected.empty()) nearest.expect(expected.subspan(i, block));
      }
      nearest.find(tree, points[i], 100, found, static_cast<std::uint32_t>(i));
      if (i % 4 == 0) together.insert(together.end(), found.begin(), found.end());
    }
    return together;
  };
  const std::vector<Found> one = all(1, {}, 1);
  ASSERT_EQ(one.size(), 150 * 100);
  expect_same(all(600, points, 1), one);
  expect_same(all(60, points, 1), one);
  expect_same(all(600, {}, 1), one);
  expect_same(all(600, points, 2), one);
  const std::vector<Vec3> elsewhere(points.rbegin(), points.rend());
  expect_same(all(200, elsewhere, 1), one);
}

TEST(NearestBeside, AnotherCountStartsAnew) {
  const std::vector<Vec3> points = along_a_curve(random_directions(1000, 12));
  const KdTree tree(points);
  NearestBeside nearest;
  std::vector<Found> found;
  for (std::uint32_t i = 0; i < 60; ++i) {
    const std::size_t count = i % 3 == 0 ? 150 : 20;
    nearest.find(tree, points[i], count, found, i);
    expect_same(found, brute_force(points, points[i], count, i));
  }
}

}  // namespace
}  // namespace deburr

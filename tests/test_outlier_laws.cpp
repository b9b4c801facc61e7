// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <limits>

#include "deburr/error.hpp"
#include "deburr/outliers.hpp"
#include "support/outlier_clouds.hpp"
#include "support/shapes.hpp"

// What may not change the flags: unit, place, order, threads, points that are not finite.

namespace deburr {
namespace {

using Flags = std::vector<std::uint8_t>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const Spoiled& cloud() {
  static const Spoiled made = spoil(cube(4000, 1).points, 0.0775, 0.02, 2, distance_to_cube);
  return made;
}

const Flags& flags() {
  static const Flags found = find_outliers(cloud().points);
  return found;
}

double disagreement(const Flags& a, const Flags& b) {
  double count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i] != b[i] ? 1 : 0;
  return count;
}

TEST(OutlierLaws, TheUnitDoesNotMatter) {
  for (const double unit : {0x1p-900, 0x1p-20, 0x1p+20, 0x1p+1000}) {
    EXPECT_EQ(find_outliers(mapped(cloud().points, [&](const Vec3& p) { return unit * p; })),
              flags())
        << unit;
  }
  // Other factors round.
  for (const double unit : {1e-6, 1e6}) {
    const auto scaled = mapped(cloud().points, [&](const Vec3& p) { return unit * p; });
    EXPECT_LE(disagreement(find_outliers(scaled), flags()), 1);
  }
}

TEST(OutlierLaws, ThePlaceDoesNotMatter) {
  // Ten million spacings away, where coordinates are rounded to 1e-9 of one.
  const auto moved = mapped(cloud().points, [](const Vec3& p) {
    return p + Vec3{775000, -775000, 775000};
  });
  EXPECT_LE(disagreement(find_outliers(moved), flags()), 1);
}

TEST(OutlierLaws, TheOrderDoesNotMatter) {
  std::vector<Vec3> shuffled;
  Flags expected;
  for (const std::uint32_t i : random_permutation(cloud().points.size(), 3)) {
    shuffled.push_back(cloud().points[i]);
    expected.push_back(flags()[i]);
  }
  EXPECT_EQ(find_outliers(shuffled), expected);
}

TEST(OutlierLaws, TheNumberOfThreadsDoesNotMatter) {
  for (const int threads : {1, 2, 3, 7}) {
    EXPECT_EQ(find_outliers(cloud().points, {}, {.threads = threads}), flags());
  }
}

TEST(OutlierLaws, PointsThatAreNotFiniteAreNoOutliersAndDoNotCount) {
  std::vector<Vec3> points = cloud().points;
  Flags expected = flags();
  points.insert(points.begin() + 1000, {not_a_number, 0, 0});
  expected.insert(expected.begin() + 1000, 0);
  points.push_back({0, infinity, 0});
  expected.push_back(0);
  EXPECT_EQ(find_outliers(points), expected);
}

TEST(OutlierLaws, HasAnAnswerForDegenerateClouds) {
  EXPECT_EQ(find_outliers({}), Flags());
  EXPECT_EQ(find_outliers(random_points(63, 4)), Flags(63));
  EXPECT_EQ(find_outliers(std::vector<Vec3>(500, {1, 2, 3})), Flags(500));
  EXPECT_EQ(find_outliers(std::vector<Vec3>(500, {0, not_a_number, 0})), Flags(500));
  const auto on_a_line = mapped(random_points(500, 5), [](const Vec3& p) {
    return Vec3{p.x, 2 * p.x, -p.x};
  });
  EXPECT_EQ(find_outliers(on_a_line), Flags(500));
  // Many ties and few places.
  EXPECT_EQ(find_outliers(grid_points(500, 6)), Flags(500));
  for (const std::size_t n : {64U, 65U, 80U, 150U, 300U}) {
    EXPECT_EQ(find_outliers(random_points(n, 7)).size(), n);
  }
}

TEST(OutlierLaws, FindsALonePointInASmallCloud) {
  std::vector<Vec3> points = mapped(random_points(120, 8), [](const Vec3& p) {
    return Vec3{p.x, p.y, 0};
  });
  points.push_back({0.5, 0.5, 1});
  Flags expected(120);
  expected.push_back(1);
  EXPECT_EQ(find_outliers(points), expected);
}

TEST(OutlierLaws, StopsWhenAsked) {
  EXPECT_THROW((void)find_outliers(cloud().points, {}, {.cancelled = [] { return true; }}),
               Cancelled);
}

TEST(OutlierLaws, TellsProgressThatNeverFalls) {
  double last = 0;
  bool falls = false;
  const Flags same = find_outliers(cloud().points, {}, {.progress = [&](const Progress& p) {
                                     falls = falls || p.fraction < last;
                                     last = p.fraction;
                                   }});
  EXPECT_FALSE(falls);
  EXPECT_EQ(last, 1);
  EXPECT_EQ(same, flags());
}

}  // namespace
}  // namespace deburr

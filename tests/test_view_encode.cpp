// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "view/encode.hpp"
#include "view/statistics.hpp"
#include "view/subsample.hpp"

// Numbers of a page, and which points it shows.

namespace deburr::view {
namespace {

TEST(ViewBase64, HasTheVectorsOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
  for (const std::size_t n : {0U, 1U, 2U, 3U, 100U}) {
    EXPECT_EQ(base64(std::string(n, 'x')).size(), base64_size(n));
  }
}

TEST(ViewQuantiser, IsNoFartherOffThanHalfAStep) {
  const Quantiser utm = Quantiser::over(4'500'000.25, 4'501'000.75, levels_24);
  for (const double value : {4'500'000.25, 4'500'123.456, 4'501'000.75}) {
    EXPECT_NEAR(utm.value(utm(value)), value, utm.step / 2 + 1e-9);
  }
  EXPECT_LT(utm.step, 1e-4);
  EXPECT_EQ(utm(-1e300), 0U);
  EXPECT_EQ(utm(1e300), levels_24);
  EXPECT_EQ(utm(std::numeric_limits<double>::quiet_NaN()), 0U);
  EXPECT_EQ(Quantiser::over(5, 5, levels_16)(5), 0U);
  const double huge = std::numeric_limits<double>::max();
  EXPECT_TRUE(std::isfinite(Quantiser::over(-huge, huge, levels_16).step));
}

TEST(ViewQuantiser, AboutZeroKeepsZero) {
  const Quantiser q = Quantiser::about_zero(0.37, levels_16);
  EXPECT_EQ(q.value(q(0)), 0);
  EXPECT_NEAR(q.value(q(-0.37)), -0.37, 1e-12);
  EXPECT_NEAR(q.value(q(0.37)), 0.37, 1e-12);
}

TEST(ViewDirections, AreAtMostAboutOneDegreeOff) {
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const double z = -1 + 2 * (i + 0.5) / 2000;
    const double turn = 2.399963 * i;
    const double r = std::sqrt(1 - z * z);
    const Vec3 n{r * std::cos(turn), r * std::sin(turn), z};
    worst = std::max(worst, std::acos(std::min(1.0, dot(n, unpack_direction(pack_direction(n))))));
  }
  EXPECT_LT(worst * 180 / std::numbers::pi, 1.1);
  for (const Vec3& axis : {Vec3{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    EXPECT_EQ(unpack_direction(pack_direction(5.0 * axis)), axis);
  }
  EXPECT_EQ(unpack_direction(pack_direction({0, 0, 0})), (Vec3{0, 0, 1}));
}

TEST(ViewNumbers, BeginWithTheLowestByte) {
  std::string bytes;
  append_number(bytes, 0x123456, 3);
  EXPECT_EQ(bytes, "\x56\x34\x12");
}

TEST(ViewSubsample, EveryBeginningOfTheOrderIsSpread) {
  for (const std::uint32_t count : {0U, 1U, 2U, 7U, 64U, 1000U}) {
    const std::vector<std::uint32_t> order = progressive_order(count);
    EXPECT_EQ(std::set<std::uint32_t>(order.begin(), order.end()).size(), count);
  }
  // Of the first 64 of 1000, no gap is more than twice as wide as it has to be.
  std::vector<std::uint32_t> first = progressive_order(1000);
  first.resize(64);
  std::ranges::sort(first);
  for (std::size_t i = 1; i < first.size(); ++i) EXPECT_LE(first[i] - first[i - 1], 32U);
  EXPECT_GE(first.back(), 960U);
}

/// A row of points.
std::vector<Vec3> row(std::size_t count) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({static_cast<double>(i), 0, 0});
  return points;
}

std::vector<std::uint32_t> all_of(const std::vector<Vec3>& points) {
  std::vector<std::uint32_t> indices(points.size());
  for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
  return indices;
}

TEST(ViewSubsample, TakesEveryNthAlongTheCurve) {
  const std::vector<Vec3> points = row(1024);
  std::vector<std::uint32_t> chosen = even_subsample(points, all_of(points), 128);
  ASSERT_EQ(chosen.size(), 128U);
  std::ranges::sort(chosen);
  for (std::size_t i = 1; i < chosen.size(); ++i) EXPECT_EQ(chosen[i] - chosen[i - 1], 8U);
  EXPECT_EQ(even_subsample(points, all_of(points), 5000).size(), 1024U);
  EXPECT_TRUE(even_subsample(points, {}, 5).empty());
}

TEST(ViewSubsample, DoesNotDependOnTheOrderOfThePoints) {
  const std::vector<Vec3> points = row(999);
  const std::vector<Vec3> backwards(points.rbegin(), points.rend());
  const std::vector<std::uint32_t> a = even_subsample(points, all_of(points), 100);
  const std::vector<std::uint32_t> b = even_subsample(backwards, all_of(points), 100);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(points[a[i]], backwards[b[i]]);
}

TEST(ViewStatistics, AreThoseOfTheDefinition) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> values{3, -4, nan, 0, 0};
  const Summary summary = summarise(values);
  EXPECT_EQ(summary.count, 4U);
  EXPECT_DOUBLE_EQ(summary.mean, 7.0 / 4);
  EXPECT_DOUBLE_EQ(summary.rms, 2.5);
  EXPECT_EQ(summary.maximum, 4);
  EXPECT_EQ(summary.percentile_95, 4);
  EXPECT_EQ(magnitude_quantile(values, 0.5), 0);
  EXPECT_EQ(magnitude_quantile(values, 0.75), 3);
  EXPECT_EQ(summarise({}).count, 0U);
  // Squares of these would not fit into a double.
  EXPECT_NEAR(summarise(std::vector<double>{1e200, 1e200}).rms, 1e200, 1e186);
}

TEST(ViewStatistics, HistogramCountsEveryFiniteValueOnce) {
  const std::vector<double> values{-3,  -2, -0.1, 0,
                                   0.1, 2,  2.5,  std::numeric_limits<double>::infinity()};
  const Histogram histogram = histogram_of(values, 2, 5);
  EXPECT_EQ(histogram.low, -2);
  EXPECT_EQ(histogram.counts, (std::vector<std::size_t>{1, 0, 3, 0, 1}));
  EXPECT_EQ(histogram.below, 1U);
  EXPECT_EQ(histogram.above, 1U);
  EXPECT_EQ(histogram_of(std::vector<double>{0, 1}, 1, 2).low, 0);
  EXPECT_EQ(histogram_of(std::vector<double>{0, 0}, 0, 3).counts[0], 2U);
}

}  // namespace
}  // namespace deburr::view

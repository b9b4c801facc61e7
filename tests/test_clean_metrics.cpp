// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "deburr/clean_metrics.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(OffsetError, IsAlongTheTrueNormals) {
  const std::vector<Vec3> clean{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  const std::vector<Vec3> points{{5, 0, 1}, {1, 0, -2}, {2, 0, 0}, {3, 0, 3}};
  // The length of a normal is of no matter; the last one looks down.
  const std::vector<Vec3> normals{{0, 0, 1}, {0, 0, 1e-200}, {0, 0, 1}, {0, 0, -1e200}};
  const OffsetError error = offset_error(points, clean, normals, 2);
  EXPECT_EQ(error.count, 4U);
  EXPECT_EQ(error.mean, (1 - 2 + 0 - 3) / 4.0);
  EXPECT_EQ(error.rms, std::sqrt(14.0 / 4));
  EXPECT_EQ(error.far_share, 0.25);  // 3 alone is more than 2
  EXPECT_EQ(offset_error(points, clean, normals, infinity).far_share, 0);
}

TEST(OffsetError, SeesASphereShrink) {
  const Sampled clean = sphere(500, 1);
  const std::vector<Vec3> points = mapped(clean.points, [](const Vec3& p) { return 0.9 * p; });
  const OffsetError error = offset_error(points, clean.points, clean.normals, 1);
  EXPECT_NEAR(error.mean, -0.1, 1e-15);
  EXPECT_NEAR(error.rms, 0.1, 1e-15);
}

TEST(OffsetError, LeavesOutWhatHasNoOffset) {
  const std::vector<Vec3> clean{{0, 0, 0}, {nan, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  const std::vector<Vec3> points{{0, infinity, 0}, {0, 0, 0}, {0, 0, 5}, {0, 0, 5}, {0, 0, 7}};
  const std::vector<Vec3> normals{{0, 0, 1}, {0, 0, 1}, {0, 0, 0}, {nan, 0, 0}, {0, 0, 1}};
  const OffsetError error = offset_error(points, clean, normals, 1);
  EXPECT_EQ(error.count, 1U);
  EXPECT_EQ(error.mean, 7);
  const OffsetError none = offset_error({}, {}, {}, 1);
  EXPECT_EQ(none.count, 0U);
  EXPECT_EQ(none.mean, 0);
}

TEST(OffsetError, RefusesWhatMakesNoSense) {
  const std::vector<Vec3> one{{0, 0, 1}};
  EXPECT_EQ(invalid_argument_of([&] { (void)offset_error(one, {}, one, 1); }),
            "clean must have one entry per point (1), got 0");
  EXPECT_EQ(invalid_argument_of([&] { (void)offset_error(one, one, {}, 1); }),
            "normals must have one entry per point (1), got 0");
  EXPECT_EQ(invalid_argument_of([&] { (void)offset_error(one, one, one, 0); }),
            "far must be > 0, got 0");
  EXPECT_NE(invalid_argument_of([&] { (void)offset_error(one, one, one, nan); }), "");
}

TEST(ScoreOutliers, CountsWhatIsRight) {
  const std::vector<std::uint8_t> flags{1, 0, 7, 0, 1, 0};
  const std::vector<std::uint8_t> truth{1, 1, 1, 0, 0, 1};
  const OutlierScore score = score_outliers(flags, truth);
  EXPECT_EQ(score.flagged, 3U);
  EXPECT_EQ(score.outliers, 4U);
  EXPECT_DOUBLE_EQ(score.precision, 2.0 / 3);
  EXPECT_DOUBLE_EQ(score.recall, 0.5);
}

TEST(ScoreOutliers, IsNanWhereThereIsNothingToTakeAShareOf) {
  const std::vector<std::uint8_t> none{0, 0};
  const std::vector<std::uint8_t> one{0, 1};
  EXPECT_TRUE(std::isnan(score_outliers(none, one).precision));
  EXPECT_EQ(score_outliers(none, one).recall, 0);
  EXPECT_TRUE(std::isnan(score_outliers(one, none).recall));
  EXPECT_EQ(score_outliers(one, none).precision, 0);
  EXPECT_EQ(invalid_argument_of([&] { (void)score_outliers(one, {}); }),
            "flags must have one entry per point (0), got 2");
}

}  // namespace
}  // namespace deburr

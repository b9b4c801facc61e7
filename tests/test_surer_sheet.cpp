// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "surer_sheet.hpp"

namespace deburr {
namespace {

/// Level sheets at heights and with variances, all around one point at 0; the noise is 1.
class Around {
 public:
  void add(double height, double variance) {
    const auto index = static_cast<std::uint32_t>(sheets_.size());
    Sheet sheet;
    sheet.frame = frame_along({0, 0, height}, {0, 0, 1});
    sheet.variance = variance;
    sheet.radius = 1;
    sheet.valid = true;
    sheets_.push_back(sheet);
    near_.push_back({static_cast<double>(index), index});
  }
  [[nodiscard]] std::uint32_t pick(std::uint32_t own) const {
    return surer_sheet({}, own, near_, sheets_, 1);
  }
  [[nodiscard]] std::uint32_t pick_alone(std::uint32_t own) const {
    return surer_sheet({}, own, {}, sheets_, 1);
  }

 private:
  std::vector<PackedSheet> sheets_;
  std::vector<Found> near_;
};

TEST(SurerSheet, IsTheOwnOneWhileThatIsSure) {
  for (const double variance : {0.01, 1.0, 2.99}) {
    Around around;
    around.add(0, variance);
    for (int i = 0; i < 10; ++i) around.add(0, 1);
    EXPECT_EQ(around.pick(0), 0U) << variance;
  }
}

TEST(SurerSheet, IsTheNearestSureOneThatTheNoiseAllows) {
  Around around;
  around.add(0, 3.5);   // itself
  around.add(0, 3.5);   // no surer
  around.add(3.2, 1);   // too far above
  around.add(-3.2, 1);  // and below
  around.add(2.9, 1);
  for (int i = 0; i < 10; ++i) around.add(0, 1);
  EXPECT_EQ(around.pick(0), 4U);
  EXPECT_EQ(around.pick(1), 4U);
  EXPECT_EQ(around.pick(KdTree::no_point), 4U);
  EXPECT_EQ(around.pick(2), 2U);
}

// A few very sure ones do not make the others unsure.
TEST(SurerSheet, GoesByTheLowerQuartile) {
  Around around;
  around.add(0, 1);
  for (int i = 0; i < 2; ++i) around.add(0, 0.01);
  for (int i = 0; i < 8; ++i) around.add(0, 1);
  EXPECT_EQ(around.pick(0), 0U);
  for (int i = 0; i < 2; ++i) around.add(0, 0.01);
  EXPECT_EQ(around.pick(0), 1U);
}

TEST(SurerSheet, IsTheOwnOneWhereNoneIsBetter) {
  Around around;
  around.add(0, 5);
  around.add(4, 1);
  around.add(-4, 1);
  EXPECT_EQ(around.pick(0), 0U);
  EXPECT_EQ(around.pick_alone(0), 0U);
  EXPECT_EQ(around.pick_alone(KdTree::no_point), KdTree::no_point);
}

}  // namespace
}  // namespace deburr

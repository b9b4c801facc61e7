// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "lanes.hpp"
#include "rows.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

TEST(Lanes, ExpIsAccurate) {
  for (int i = 0; i < 1890; ++i) {
    const double x = -0.37 * i;
    const double expected = std::exp(x);
    EXPECT_NEAR(exp_of_negative(all_lanes(x))[3], expected, 2e-15 * expected) << x;
  }
}

TEST(Lanes, ExpVanishesFarOut) {
  for (const double x : {-700.5, -1e4, -1e300, -HUGE_VAL}) {
    EXPECT_EQ(exp_of_negative(all_lanes(x))[0], 0) << x;
  }
}

TEST(Lanes, LoadFillsTheRestWithZero) {
  const std::vector<Vec3> values = random_points(30, 1);
  std::vector<std::uint32_t> list;
  for (std::uint32_t i = 0; i < 11; ++i) list.push_back(2 * i);
  const Lanes3 full = load(values, list, 0);
  const Lanes3 rest = load(values, list, 8);
  const Lanes there = present(list.size(), 8);
  for (std::size_t l = 0; l < lane_count; ++l) {
    EXPECT_EQ(full.y[l], values[list[l]].y);
    EXPECT_EQ(rest.x[l], l < 3 ? values[list[8 + l]].x : 0);
    EXPECT_EQ(there[l], l < 3 ? 1 : 0);
  }
}

TEST(Rows, LoadsWhatTheVectorsHold) {
  const std::vector<Vec3> values = random_points(30, 2);
  const std::vector<Row> rows = make_rows(values, {});
  for (std::size_t size = 1; size <= 17; ++size) {
    std::vector<std::uint32_t> list;
    for (std::uint32_t k = 0; k < size; ++k) list.push_back(7 * k % 30);
    for (std::size_t from = 0; from < size; from += lane_count) {
      const Lanes3 expected = load(values, list, from);
      const Lanes3 loaded = load(rows.data(), list, from);
      for (std::size_t l = 0; l < lane_count; ++l) {
        EXPECT_EQ(lane(loaded, l), lane(expected, l)) << size << ' ' << from << ' ' << l;
      }
    }
  }
}

TEST(Lanes, SumAddsEveryLaneOnce) { EXPECT_EQ(sum(Lanes{1, 2, 4, 8, 16, 32, 64, 128}), 255); }

}  // namespace
}  // namespace deburr

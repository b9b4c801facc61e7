// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lane_sort.hpp"
#include "random.hpp"

namespace deburr {
namespace {

void expect_sorted(std::vector<double> values) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  sort_in_lanes(values.data(), values.size());
  EXPECT_EQ(values, sorted) << values.size();
}

TEST(LaneSort, SortsValuesOfAnyOrder) {
  Random random(1);
  for (const std::size_t size : lane_sort_sizes) {
    std::vector<double> values(size);
    for (int trial = 0; trial < 50; ++trial) {
      for (double& v : values) v = random.uniform();
      expect_sorted(values);
    }
    std::sort(values.begin(), values.end());
    expect_sorted(values);
    std::reverse(values.begin(), values.end());
    expect_sorted(values);
  }
}

TEST(LaneSort, SortsZerosAndOnes) {
  // What sorts all sequences of zeros and ones sorts all sequences (Knuth 5.3.4, theorem Z).
  Random random(2);
  for (const std::size_t size : lane_sort_sizes) {
    std::vector<double> values(size);
    for (int trial = 0; trial < 300; ++trial) {
      const double share = random.uniform();
      for (double& v : values) v = random.uniform() < share ? 1 : 0;
      expect_sorted(values);
    }
  }
}

TEST(LaneSort, SortsEqualAndInfiniteValues) {
  Random random(3);
  for (const std::size_t size : lane_sort_sizes) {
    std::vector<double> values(size, std::numeric_limits<double>::infinity());
    expect_sorted(values);
    for (std::size_t k = 0; k < size / 2; ++k) values[k] = std::floor(8 * random.uniform()) - 4;
    expect_sorted(values);
  }
}

}  // namespace
}  // namespace deburr

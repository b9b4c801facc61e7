// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <vector>

#include "take_out.hpp"

namespace deburr {
namespace {

using Marks = std::vector<std::uint8_t>;

TEST(TakeOut, TakesTheMarkedOutAndPutsThemBack) {
  // Every choice of five values, so ends, runs, all and none are among them.
  for (unsigned choice = 0; choice < 32; ++choice) {
    Marks marks(5);
    std::vector<int> marked;
    std::vector<int> others;
    for (int i = 0; i < 5; ++i) {
      const bool goes = (choice >> i & 1U) != 0;
      marks[static_cast<std::size_t>(i)] = goes ? 1 : 0;
      (goes ? marked : others).push_back(i);
    }
    std::vector<int> values(5);
    std::iota(values.begin(), values.end(), 0);
    const std::vector<int> all = values;
    std::vector<int> taken = take_out(values, marks);
    EXPECT_EQ(taken, marked);
    EXPECT_EQ(values, others);
    put_back(values, std::move(taken), marks, {});
    EXPECT_EQ(values, all);
  }
}

TEST(TakeOut, IsNothingOfNothing) {
  std::vector<int> none;
  EXPECT_TRUE(take_out(none, Marks{}).empty());
  put_back(none, {}, Marks{}, {});
  EXPECT_TRUE(none.empty());
}

TEST(TakeOut, MovesValuesThatCannotBeCopied) {
  std::vector<std::unique_ptr<int>> values;
  for (int i = 0; i < 3; ++i) values.push_back(std::make_unique<int>(i));
  const Marks marks{0, 1, 0};
  std::vector<std::unique_ptr<int>> taken = take_out(values, marks);
  ASSERT_EQ(values.size(), 2U);
  EXPECT_EQ(*values[1], 2);
  put_back(values, std::move(taken), marks, {});
  for (int i = 0; i < 3; ++i) EXPECT_EQ(*values[static_cast<std::size_t>(i)], i);
}

}  // namespace
}  // namespace deburr

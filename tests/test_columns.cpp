// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstdint>

#include "columns.hpp"

namespace deburr {
namespace {

using ::testing::Each;
using ::testing::IsEmpty;

TEST(Columns, KeepTheirValuesWhereTheyGrow) {
  std::vector<int> column{1, 2, 3};
  resize_column(column, 100000, {.threads = 2});
  ASSERT_EQ(column.size(), 100000);
  EXPECT_THAT(std::vector<int>(column.begin(), column.begin() + 3), testing::ElementsAre(1, 2, 3));
  EXPECT_THAT(std::vector<int>(column.begin() + 3, column.end()), Each(0));
  resize_column(column, 2, {});
  EXPECT_THAT(column, testing::ElementsAre(1, 2));
}

TEST(Columns, AreNewValuesEvenInMemoryThatHeldOthers) {
  std::vector<int> column(50000, 7);
  resize_column(column, 1, {});
  resize_column(column, 50000, {});
  EXPECT_EQ(column[0], 7);
  EXPECT_THAT(std::vector<int>(column.begin() + 1, column.end()), Each(0));
}

TEST(Columns, AreCopiedWhole) {
  std::vector<std::uint32_t> values(5000);
  for (std::uint32_t i = 0; i < values.size(); ++i) values[i] = 3 * i;
  EXPECT_EQ(copy_column(std::span<const std::uint32_t>(values), {.threads = 3}), values);
}

/// Every third number, with blocks of a size.
std::vector<std::size_t> every_third(std::size_t n, std::size_t block) {
  std::vector<std::size_t> picked;
  pick(
      n, [](std::size_t i) { return i % 3 == 1; }, [&](std::size_t count) { picked.resize(count); },
      [&](std::size_t i, std::size_t k) { picked[k] = i; }, {.threads = 3, .block = block});
  return picked;
}

TEST(Columns, PickWhatIsWantedInOrder) {
  for (const std::size_t n : {0, 1, 2, 1023, 1024, 1025, 5000}) {
    std::vector<std::size_t> expected;
    for (std::size_t i = 1; i < n; i += 3) expected.push_back(i);
    EXPECT_EQ(every_third(n, block_size), expected) << n;
  }
}

TEST(Columns, PickTheSameInBlocksOfAnySize) {
  const std::vector<std::size_t> whole = every_third(5000, block_size);
  for (const std::size_t block : {1, 7, 1500}) EXPECT_EQ(every_third(5000, block), whole) << block;
}

TEST(Columns, PickNothingWhereNothingIsWanted) {
  std::vector<int> picked(3);
  pick(
      100, [](std::size_t) { return false; }, [&](std::size_t count) { picked.resize(count); },
      [&](std::size_t, std::size_t k) { picked[k] = 1; }, {});
  EXPECT_THAT(picked, IsEmpty());
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include "radix_sort.hpp"

namespace deburr {
namespace {

struct Item {
  std::uint64_t key;
  std::uint32_t index;
  friend bool operator==(const Item&, const Item&) = default;
};

/// Items whose keys differ in the bits of `mask` alone.
std::vector<Item> random_items(std::size_t count, std::uint64_t mask) {
  std::mt19937_64 random(7);
  std::vector<Item> items(count);
  for (std::size_t i = 0; i < count; ++i) {
    items[i] = {random() & mask, static_cast<std::uint32_t>(i)};
  }
  return items;
}

template <unsigned digits>
void expect_sorted(std::vector<Item> items, const Execution& execution) {
  std::vector<Item> expected = items;
  std::ranges::stable_sort(expected, {}, &Item::key);
  std::vector<Item> scratch;
  radix_sort<digits>(
      std::span(items), scratch, [](const Item& item) { return item.key; }, execution);
  EXPECT_TRUE(items == expected) << items.size() << " items, " << digits << " digits";
}

TEST(RadixSort, SortsAsAStableSortDoes) {
  for (const std::size_t count : {0, 1, 2, 1000, 100000}) {
    expect_sorted<6>(random_items(count, ~std::uint64_t{0} >> 1), {.threads = 2});
    expect_sorted<3>(random_items(count, (std::uint64_t{1} << 33) - 1), {.threads = 2});
    expect_sorted<2>(random_items(count, 0x3ff), {.threads = 2});
  }
}

TEST(RadixSort, LeavesItemsOfOneKeyInTheirOrder) {
  expect_sorted<3>(random_items(100000, 3), {.threads = 3});
  expect_sorted<3>(random_items(100000, 0), {.threads = 3});
}

TEST(RadixSort, LooksAtTheLowestDigitsAlone) {
  std::vector<Item> items{{std::uint64_t{1} << radix_bits, 0}, {1, 1}, {0, 2}};
  std::vector<Item> scratch;
  radix_sort<1>(std::span(items), scratch, [](const Item& item) { return item.key; }, {});
  EXPECT_EQ(items[0].index, 0);
  EXPECT_EQ(items[1].index, 2);
  EXPECT_EQ(items[2].index, 1);
}

TEST(RadixSort, IsTheSameInBlocksOfAnySize) {
  expect_sorted<6>(random_items(100000, ~std::uint64_t{0} >> 1), {.threads = 2, .block = 10});
}

}  // namespace
}  // namespace deburr

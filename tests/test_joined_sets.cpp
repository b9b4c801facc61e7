// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "joined_sets.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

TEST(JoinedSets, AreKnownByTheirSmallestMember) {
  JoinedSets sets(6, {});
  EXPECT_TRUE(sets.join(5, 3));
  EXPECT_TRUE(sets.join(4, 5));
  EXPECT_FALSE(sets.join(3, 4));
  for (const std::uint32_t i : {3U, 4U, 5U}) EXPECT_EQ(sets.find(i), 3);
  EXPECT_EQ(sets.find(2), 2);
  EXPECT_TRUE(sets.join(4, 1));
  EXPECT_EQ(sets.find(5), 1);
}

TEST(JoinedSets, AreTheSameWhoeverJoinsThem) {
  constexpr std::size_t count = 50000;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::mt19937_64 random(3);
  for (std::size_t k = 0; k < count * 9 / 10; ++k) {
    pairs.emplace_back(static_cast<std::uint32_t>(random() % count),
                       static_cast<std::uint32_t>(random() % count));
  }
  // In one chain as well, along which threads get in each other's way.
  for (std::uint32_t i = 1; i < 20000; ++i) pairs.emplace_back(i, i - 1);
  JoinedSets one_by_one(count, {});
  std::size_t joined_one_by_one = 0;
  for (const auto& [i, j] : pairs) joined_one_by_one += one_by_one.join(i, j) ? 1 : 0;

  JoinedSets at_once(count, {});
  const double joined = parallel_sum(pairs.size(), {.threads = 7, .block = 16}, [&](std::size_t k) {
    return at_once.join(pairs[k].first, pairs[k].second) ? 1 : 0;
  });
  EXPECT_EQ(joined, static_cast<double>(joined_one_by_one));
  for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(at_once.find(i), one_by_one.find(i)) << i;
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <stdexcept>

#include "parallel.hpp"

namespace deburr {
namespace {

using ::testing::Each;

/// How often each item is visited.
template <std::size_t size>
std::vector<int> visits(std::size_t n, std::size_t block) {
  std::vector<int> count(n);
  parallel_for<size>(n, {.threads = 3, .block = block}, [&](std::size_t i) { ++count[i]; });
  return count;
}

TEST(Parallel, VisitsEveryItemOnceInBlocksOfAnySize) {
  for (const std::size_t n : {0, 1, 1023, 1025, 5000}) {
    for (const std::size_t block : {1, 100, 1024, 3000, 1000000}) {
      EXPECT_THAT(visits<1>(n, block), Each(1)) << n << " " << block;
      EXPECT_THAT(visits<16>(n, block), Each(1)) << n << " " << block;
      EXPECT_THAT(visits<block_size>(n, block), Each(1)) << n << " " << block;
    }
  }
}

/// Waits for something that another thread does, but not for ever.
template <typename Happened>
void wait_until(const Happened& happened) {
  for (int k = 0; k < 10000000 && !happened(); ++k) std::this_thread::yield();
}

TEST(Parallel, TellsProgressOnTheCallersThreadUpToTheEnd) {
  constexpr std::size_t n = 1000 * block_size;
  std::vector<double> told;
  std::atomic<std::size_t> elsewhere = 0;
  const auto me = std::this_thread::get_id();
  const Execution execution{.threads = 2, .progress = [&](const Progress& progress) {
                              if (std::this_thread::get_id() != me) ++elsewhere;
                              told.push_back(progress.fraction);
                            }};
  // The other thread begins before this one ends its first block, and ends after its last.
  std::atomic<bool> other_is_there = false;
  std::atomic<std::size_t> visited = 0;
  parallel_for(n, execution, [&](std::size_t i) {
    const bool first = i % block_size == 0;
    if (first && std::this_thread::get_id() == me) {
      wait_until([&] { return other_is_there.load(); });
    } else if (first) {
      other_is_there = true;
      wait_until([&] { return visited >= n - block_size; });
    }
    ++visited;
  });
  EXPECT_TRUE(other_is_there);
  EXPECT_EQ(elsewhere, 0);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_GT(told.size(), 10);
  EXPECT_LE(told.size(), 66);
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back(), 1);
}

TEST(Parallel, TellsTheEndOfOneBlock) {
  std::vector<double> told;
  parallel_for(5,
               {.progress = [&](const Progress& progress) { told.push_back(progress.fraction); }},
               [](std::size_t) {});
  EXPECT_THAT(told, testing::ElementsAre(1));
}

TEST(Parallel, HandsOnWhatIsThrown) {
  const Execution fails{.threads = 3,
                        .progress = [](const Progress&) { throw std::runtime_error("progress"); }};
  EXPECT_THROW(parallel_for(100000, fails, [](std::size_t) {}), std::runtime_error);
  const auto body = [](std::size_t i) {
    if (i == 70000) throw std::logic_error("body");
  };
  EXPECT_THROW(parallel_for(100000, {.threads = 3}, body), std::logic_error);
}

TEST(Parallel, StopsWhenTheCallerAsks) {
  std::atomic<std::size_t> visited = 0;
  const Execution stops{.threads = 2, .cancelled = [&] { return visited >= 5000; }};
  EXPECT_THROW(parallel_for(1000000, stops, [&](std::size_t) { ++visited; }), Cancelled);
  EXPECT_LT(visited, 20000);
}

}  // namespace
}  // namespace deburr

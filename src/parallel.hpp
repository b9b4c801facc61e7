// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <thread>
#include <vector>

#include "deburr/error.hpp"
#include "deburr/execution.hpp"
#include "require.hpp"

// The only place that knows of threads. Every loop writes item i from item i, and sums are added in
// a fixed order, so that results have the same bits for any number of threads.

namespace deburr {

/// Items that are worked on, or summed, as one.
inline constexpr std::size_t block_size = 1024;

/// More are never of use, and a slip of the finger must not bring a machine down.
inline constexpr int most_threads = 256;

/// Throws Cancelled if the caller has asked to stop.
inline void check_cancelled(const Execution& execution) {
  if (execution.cancelled && execution.cancelled()) throw Cancelled();
}

/// Looks at the caller's wish to stop now and then, in a loop over items that take next to no time.
class CancelWatch {
 public:
  explicit CancelWatch(const Execution& execution) : execution_(execution) {}
  /// Called for every item.
  void operator()() {
    if (++items_ % (64 * block_size) == 0) check_cancelled(execution_);
  }

 private:
  const Execution& execution_;
  std::uint32_t items_ = 0;
};

/// The same, but for progress.
inline Execution without_progress(const Execution& execution) {
  Execution same = execution;
  same.progress = nullptr;
  return same;
}

/// Number of threads that `execution` asks for.
inline int thread_count(const Execution& execution) {
  require(execution.threads >= 0 && execution.threads <= most_threads, "threads", "in [0, 256]",
          execution.threads);
  return execution.threads > 0 ? execution.threads : tbb::this_task_arena::max_concurrency();
}

/// The part [from, to] of the progress of `whole`, under the name of a stage.
inline Execution sub_execution(const Execution& whole, std::string_view stage, double from,
                               double to) {
  Execution part = whole;
  if (whole.progress) {
    part.progress = [progress = whole.progress, stage, from, to](const Progress& inner) {
      progress({stage, from + (to - from) * inner.fraction});
    };
  }
  return part;
}

/// Runs `work`, in which TBB uses the threads that `execution` asks for.
template <typename Work>
void with_threads(const Execution& execution, const Work& work) {
  const auto threads = static_cast<std::size_t>(thread_count(execution));
  // More threads than cores are wanted where results are tested against their number.
  const auto limit = tbb::global_control::max_allowed_parallelism;
  const tbb::global_control allow(limit,
                                  std::max(threads, tbb::global_control::active_value(limit)));
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute(work);
}

/// Sorts values that are all different, so that the result does not depend on the threads.
template <typename Value, typename Less = std::less<Value>>
void parallel_sort(std::vector<Value>& values, const Execution& execution,
                   const Less& before = {}) {
  const auto less = [&](const Value& a, const Value& b) {
    // A sort of many millions takes seconds, and has no other place to stop at.
    thread_local std::uint32_t comparisons = 0;
    if (++comparisons % (64 * block_size) == 0) check_cancelled(execution);
    return before(a, b);
  };
  with_threads(execution, [&] { tbb::parallel_sort(values.begin(), values.end(), less); });
}

/// Calls body(begin, end) on blocks that cover [0, n); any exception is thrown on to the caller.
/// Blocks are of `size` items unless the caller wants others. Those that begin within the same
/// `size` items, counted from 0, are worked on one after the other and by one thread: what they
/// gather may be kept by begin / size.
template <std::size_t size = block_size, typename Body>
void parallel_blocks(std::size_t n, const Execution& execution, const Body& body) {
  const std::size_t wanted = std::min(execution.block, n);
  const std::size_t block =
      wanted == 0 ? size : std::max<std::size_t>(1, wanted * size / block_size);
  const std::size_t task = (block + size - 1) / size * size;
  const std::size_t tasks = (n + task - 1) / task;
  std::atomic<std::size_t> done = 0;
  // Progress is told on the caller's thread, between its own tasks, and not after every one.
  const auto caller = std::this_thread::get_id();
  std::size_t told = 0;
  const auto tell = [&] {
    constexpr std::size_t steps = 64;
    const std::size_t so_far = ++done;
    if (!execution.progress || std::this_thread::get_id() != caller) return;
    if ((so_far - told) * steps < tasks && so_far < tasks) return;
    told = so_far;
    execution.progress({"", static_cast<double>(so_far) / static_cast<double>(tasks)});
  };
  check_cancelled(execution);
  if (n == 0) return;
  with_threads(execution, [&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, tasks, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t t = range.begin(); t != range.end(); ++t) {
            const std::size_t end = std::min(n, (t + 1) * task);
            for (std::size_t begin = t * task; begin < end; begin += block) {
              check_cancelled(execution);
              body(begin, std::min(end, begin + block));
            }
            tell();
          }
        },
        tbb::simple_partitioner());
  });
  // What was asked for when the last blocks were under way is heard here, not by the next loop.
  check_cancelled(execution);
  if (execution.progress && told < tasks) execution.progress({"", 1.0});
}

/// Calls body(i) for every i in [0, n). Items that are much work each are worth smaller blocks.
template <std::size_t size = block_size, typename Body>
void parallel_for(std::size_t n, const Execution& execution, const Body& body) {
  parallel_blocks<size>(n, execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

/// Sum of term(i) over [0, n): first within blocks, then over the blocks, both in order.
template <typename Term>
double parallel_sum(std::size_t n, const Execution& execution, const Term& term) {
  std::vector<double> sums((n + block_size - 1) / block_size);
  // What is added first must not depend on how many points the caller wants in a block.
  parallel_blocks(n, execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) sums[i / block_size] += term(i);
  });
  double total = 0;
  for (const double sum : sums) total += sum;
  return total;
}

}  // namespace deburr

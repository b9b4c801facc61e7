// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "deburr/execution.hpp"
#include "large_pages.hpp"
#include "parallel.hpp"

// Columns of values for every point, made and filled by all threads.

namespace deburr {

/// Bytes of a column that is in large pages.
inline constexpr std::size_t large_column = std::size_t{6} << 20;

/// Makes room for as many values, as reserve() does, but in large pages, and all threads touch
/// them: it takes the system longer to clear new pages, which it does when they are touched, than
/// to fill them.
template <typename T>
void reserve_column(std::vector<T>& column, std::size_t size, const Execution& execution) {
  constexpr std::size_t page = 4096;
  constexpr std::size_t pages_of_block = 64;
  if (size <= column.capacity()) return;
  std::vector<T> larger;
  larger.reserve(size);
  // In large pages as well, unless what they are too large for weighs more.
  if (size * sizeof(T) >= large_column) prefer_large_pages(larger.data(), size * sizeof(T));
  // No value is there yet, so that bytes may be written.
  auto* const bytes = reinterpret_cast<volatile unsigned char*>(larger.data());
  parallel_blocks<pages_of_block>(size * sizeof(T) / page, without_progress(execution),
                                  [&](std::size_t begin, std::size_t end) {
                                    for (std::size_t k = begin; k < end; ++k) bytes[k * page] = 0;
                                  });
  std::ranges::move(column, std::back_inserter(larger));
  column = std::move(larger);
}

/// Has `column` hold as many values, as resize() does, in memory of reserve_column().
template <typename T>
void resize_column(std::vector<T>& column, std::size_t size, const Execution& execution) {
  reserve_column(column, size, execution);
  column.resize(size);
}

/// A column of as many T().
template <typename T>
std::vector<T> make_column(std::size_t size, const Execution& execution) {
  std::vector<T> column;
  resize_column(column, size, execution);
  return column;
}

/// The same values once more.
template <typename T>
std::vector<T> copy_column(std::span<const T> values, const Execution& execution) {
  auto copy = make_column<T>(values.size(), execution);
  parallel_for(values.size(), without_progress(execution),
               [&](std::size_t i) { copy[i] = values[i]; });
  return copy;
}

/// Gives the memory of a column back, which assigning {} does not.
template <typename T>
void release(std::vector<T>& column) {
  column = std::vector<T>();
}

/// Calls put(i, k) for the k-th of the i in [0, n) that are wanted, after room(count) for all.
template <typename Wanted, typename Room, typename Put>
void pick(std::size_t n, const Wanted& wanted, const Room& room, const Put& put,
          const Execution& execution) {
  const Execution quiet = without_progress(execution);
  std::vector<std::size_t> next((n + block_size - 1) / block_size + 1);
  parallel_blocks(n, quiet, [&](std::size_t begin, std::size_t end) {
    std::size_t& count = next[begin / block_size + 1];
    for (std::size_t i = begin; i < end; ++i) count += wanted(i) ? 1 : 0;
  });
  std::partial_sum(next.begin(), next.end(), next.begin());
  room(next.back());
  parallel_blocks(n, quiet, [&](std::size_t begin, std::size_t end) {
    std::size_t& k = next[begin / block_size];
    for (std::size_t i = begin; i < end; ++i) {
      if (wanted(i)) put(i, k++);
    }
  });
}

}  // namespace deburr

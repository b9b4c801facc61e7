// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "columns.hpp"
#include "parallel.hpp"

namespace deburr {

/// Disjoint sets that many threads join at once. The smallest member stands for a set, so that the
/// result does not depend on the order in which they are joined. After Anderson and Woll, Wait-free
/// parallel algorithms for the union-find problem, 1991, but with members in order instead of
/// ranks.
class JoinedSets {
 public:
  JoinedSets(std::size_t n, const Execution& execution)
      : parent_(make_column<std::uint32_t>(n, execution)) {
    parallel_for(n, without_progress(execution),
                 [&](std::size_t i) { parent_[i] = static_cast<std::uint32_t>(i); });
  }

  /// The smallest member of the set of i, as far as it is joined.
  std::uint32_t find(std::uint32_t i) {
    for (;;) {
      std::uint32_t up = parent(i).load(std::memory_order_relaxed);
      if (up == i) return i;
      // Another thread may have been there first: whatever it wrote, this is above i as well.
      const std::uint32_t above = parent(up).load(std::memory_order_relaxed);
      parent(i).store(above, std::memory_order_relaxed);
      i = above;
    }
  }

  /// Joins the sets of i and j; false if they are one already.
  bool join(std::uint32_t i, std::uint32_t j) {
    for (;;) {
      i = find(i);
      j = find(j);
      if (i == j) return false;
      if (i < j) std::swap(i, j);
      std::uint32_t root = i;
      if (parent(i).compare_exchange_strong(root, j, std::memory_order_relaxed)) return true;
    }
  }

 private:
  /// As large as the member only where that is a root; one that is none is never one again.
  std::atomic_ref<std::uint32_t> parent(std::uint32_t i) {
    return std::atomic_ref<std::uint32_t>(parent_[i]);
  }

  std::vector<std::uint32_t> parent_;
};

}  // namespace deburr

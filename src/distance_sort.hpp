// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "found_sort.hpp"

namespace deburr {

/// Sorts what a search within a radius found, by (distance, index).
class DistanceSort {
 public:
  /// @param largest  squared distance that none of those to be sorted exceeds, > 0
  explicit DistanceSort(double largest) : largest_(largest) {}

  /// Makes room for so many.
  void reserve(std::size_t most);
  /// Where what was found is put, before write().
  [[nodiscard]] double* squared_distances() { return squared_.data(); }
  [[nodiscard]] std::uint32_t* indices() { return indices_.data(); }

  /// Writes the indices of the `wanted` nearest of the `size` that were put, but for `self`, which
  /// is one of them.
  void write(std::size_t size, std::uint32_t self, std::size_t wanted, std::uint32_t* to);

 private:
  bool rank(std::size_t size, std::size_t wanted, std::uint32_t* to);

  double largest_;
  std::vector<double> squared_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint64_t> ranks_;
  std::vector<Found> found_;
  FoundSort sort_;
};

}  // namespace deburr

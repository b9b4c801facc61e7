// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kd_tree.hpp"

namespace deburr {

/// Sorts what a search within a radius found, by (distance, index). Squared distances on a surface
/// are spread evenly, so that a bucket for each of them leaves little to compare.
class DistanceSort {
 public:
  /// @param largest  squared distance that none of those to be sorted exceeds, > 0
  explicit DistanceSort(double largest) : largest_(largest) {}

  /// Writes the indices of the `wanted` first. Changes the order of `found`.
  void write(std::span<Found> found, std::size_t wanted, std::uint32_t* to) {
    std::span<const Found> sorted = found;
    if (found.size() <= fewest) {
      insert(found);
    } else if (spread(found)) {
      // Whole buckets, of which the last has the last that is wanted.
      const std::size_t used = wanted > 0 ? ends_[bucket(spread_[wanted - 1])] : 0;
      insert(std::span(spread_).first(used));
      sorted = spread_;
    } else {
      std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(wanted),
                        found.end());
    }
    for (std::size_t k = 0; k < wanted; ++k) to[k] = sorted[k].index;
  }

 private:
  static constexpr std::size_t fewest = 12;
  static constexpr std::uint32_t fullest = 24;

  static void insert(std::span<Found> values) {
    for (std::size_t k = 1; k < values.size(); ++k) {
      const Found f = values[k];
      std::size_t at = k;
      for (; at > 0 && f < values[at - 1]; --at) values[at] = values[at - 1];
      values[at] = f;
    }
  }

  [[nodiscard]] std::size_t bucket(const Found& f) const {
    return static_cast<std::size_t>(f.squared_distance * per_bucket_);
  }

  /// Copies to spread_ by bucket; false if a bucket is too full for insertion.
  bool spread(std::span<const Found> found) {
    const std::size_t buckets = 2 * found.size();
    per_bucket_ = static_cast<double>(buckets - 1) / largest_;
    ends_.assign(buckets, 0);
    for (const Found& f : found) ++ends_[bucket(f)];
    std::uint32_t sum = 0;
    std::uint32_t most = 0;
    for (std::uint32_t& end : ends_) {
      most = std::max(most, end);
      const std::uint32_t begin = sum;
      sum += end;
      end = begin;
    }
    if (most > fullest) return false;
    spread_.resize(found.size());
    for (const Found& f : found) spread_[ends_[bucket(f)]++] = f;
    return true;
  }

  double largest_;
  double per_bucket_ = 0;
  std::vector<std::uint32_t> ends_;
  std::vector<Found> spread_;
};

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "kd_tree.hpp"

namespace deburr {

/// Sorts what a search found by (distance, index): into buckets, then within them.
class FoundSort {
 public:
  /// Leaves the `wanted` nearest, in order. There must be so many.
  /// @param largest  squared distance that none exceeds
  void sort(std::vector<Found>& found, std::size_t wanted, double largest);

 private:
  bool spread(const std::vector<Found>& found);
  [[nodiscard]] std::size_t bucket(const Found& f) const {
    return static_cast<std::size_t>(f.squared_distance * per_bucket_);
  }

  double per_bucket_ = 0;
  std::vector<std::uint32_t> ends_;
  std::vector<Found> spread_;
};

}  // namespace deburr

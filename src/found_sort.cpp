// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "found_sort.hpp"

#include <algorithm>
#include <span>

namespace deburr {
namespace {

/// A bucket with more than this is not sorted by insertion.
constexpr std::uint32_t fullest = 24;

void insert(std::span<Found> values) {
  for (std::size_t k = 1; k < values.size(); ++k) {
    const Found f = values[k];
    std::size_t at = k;
    for (; at > 0 && f < values[at - 1]; --at) values[at] = values[at - 1];
    values[at] = f;
  }
}

}  // namespace

void FoundSort::sort(std::vector<Found>& found, std::size_t wanted, double largest) {
  if (wanted == 0) return found.clear();
  per_bucket_ = static_cast<double>(2 * found.size() - 1) / largest;
  // A distance may be beyond all numbers.
  if (per_bucket_ > 1e-300 && per_bucket_ < 1e300 && spread(found)) {
    // Whole buckets, of which the last has the last that is wanted.
    insert(std::span(spread_).first(ends_[bucket(spread_[wanted - 1])]));
    found.swap(spread_);
  } else {
    std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(wanted),
                      found.end());
  }
  found.resize(wanted);
}

/// Copies to spread_ by bucket; false if a bucket is too full for insertion. Squared distances on a
/// surface are spread evenly, so that few share one.
bool FoundSort::spread(const std::vector<Found>& found) {
  ends_.assign(2 * found.size(), 0);
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

}  // namespace deburr

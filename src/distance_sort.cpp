// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "distance_sort.hpp"

#include <algorithm>
#include <cstring>

#include "lanes.hpp"

namespace deburr {
namespace {

/// So few are ranked by counting, for each, all that are nearer.
constexpr std::size_t few = 96;

/// A bucket with more than this is not sorted by insertion.
constexpr std::uint32_t fullest = 24;

/// For each of the values, how many of them are smaller. Both arrays have room for whole lanes.
DEBURR_MULTIVERSION
void count_smaller(const double* values, std::size_t size, std::uint64_t* counts) {
  for (std::size_t from = 0; from < size; from += lane_count) {
    Lanes v;
    std::memcpy(&v, values + from, sizeof v);
    LaneBits smaller{};
    for (std::size_t k = 0; k < size; ++k) smaller -= values[k] < v;
    std::memcpy(counts + from, &smaller, sizeof smaller);
  }
}

void insert(std::span<Found> values) {
  for (std::size_t k = 1; k < values.size(); ++k) {
    const Found f = values[k];
    std::size_t at = k;
    for (; at > 0 && f < values[at - 1]; --at) values[at] = values[at - 1];
    values[at] = f;
  }
}

}  // namespace

void DistanceSort::reserve(std::size_t most) {
  const std::size_t room = most + lane_count;
  if (squared_.size() >= room) return;
  squared_.resize(2 * room);
  indices_.resize(2 * room);
  ranks_.resize(2 * room);
}

/// By ranks; false if two distances are the same, since the index decides then.
bool DistanceSort::rank(std::size_t size, std::size_t wanted, std::uint32_t* to) {
  count_smaller(squared_.data(), size, ranks_.data());
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < size; ++k) sum += ranks_[k];
  if (sum != size * (size - 1) / 2) return false;
  for (std::size_t k = 0; k < size; ++k) {
    if (ranks_[k] < wanted) to[ranks_[k]] = indices_[k];
  }
  return true;
}

void DistanceSort::write(std::size_t size, std::uint32_t self, std::size_t wanted,
                         std::uint32_t* to) {
  if (wanted == 0) return;
  const auto at = static_cast<std::size_t>(std::find(indices_.begin(), indices_.end(), self) -
                                           indices_.begin());
  --size;
  squared_[at] = squared_[size];
  indices_[at] = indices_[size];
  if (size <= few && rank(size, wanted, to)) return;

  found_.resize(size);
  for (std::size_t k = 0; k < size; ++k) found_[k] = {squared_[k], indices_[k]};
  const std::vector<Found>* sorted = &found_;
  if (spread(found_)) {
    // Whole buckets, of which the last has the last that is wanted.
    insert(std::span(spread_).first(ends_[bucket(spread_[wanted - 1])]));
    sorted = &spread_;
  } else {
    std::partial_sort(found_.begin(), found_.begin() + static_cast<std::ptrdiff_t>(wanted),
                      found_.end());
  }
  for (std::size_t k = 0; k < wanted; ++k) to[k] = (*sorted)[k].index;
}

/// Copies to spread_ by bucket; false if a bucket is too full for insertion. Squared distances on a
/// surface are spread evenly, so that few share one.
bool DistanceSort::spread(std::span<const Found> found) {
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

}  // namespace deburr

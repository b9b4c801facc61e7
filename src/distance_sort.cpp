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
  sort_.sort(found_, wanted, largest_);
  for (std::size_t k = 0; k < wanted; ++k) to[k] = found_[k].index;
}

}  // namespace deburr

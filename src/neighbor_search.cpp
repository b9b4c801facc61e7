// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "neighbor_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "deburr/error.hpp"
#include "deburr/neighborhoods.hpp"
#include "parallel.hpp"

namespace deburr {

NeighborSearch::NeighborSearch(Points points, double radius, const Execution& execution)
    : points_(points), radius_(radius), grid_(CellGrid::make(points, radius, 0, execution)) {
  if (!grid_) {
    tree_ = std::make_unique<KdTree>(points, execution);
    return;
  }
  slot_.resize(points.size());
  parallel_for(points.size(), execution, [&](std::size_t slot) {
    slot_[grid_->index(slot)] = static_cast<std::uint32_t>(slot);
  });
}

std::vector<std::uint32_t> NeighborSearch::count_all(const Execution& execution) const {
  std::vector<std::uint32_t> counts(points_.size());
  if (grid_) {
    parallel_blocks(points_.size(), execution, [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> here(end - begin);
      grid_->count(begin, end, here.data());
      for (std::size_t slot = begin; slot < end; ++slot) {
        counts[grid_->index(slot)] = static_cast<std::uint32_t>(here[slot - begin]);
      }
    });
  } else {
    // Along the leaves of the tree one search warms the cache for the next.
    parallel_for(points_.size(), execution, [&](std::size_t at) {
      const std::uint32_t i = tree_->order()[at];
      counts[i] = static_cast<std::uint32_t>(tree_->count_within(i, radius_ * radius_));
    });
  }
  const std::size_t pairs = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (pairs > max_pairs) {
    throw DataError(too_many_pairs(points_.size(), radius_, pairs));
  }
  return counts;
}

void NeighborSearch::find(std::size_t begin, std::span<const std::uint32_t> counts,
                          std::uint32_t* to) const {
  if (grid_) {
    std::vector<CellGrid::Query> queries(counts.size());
    for (std::size_t k = 0; k < counts.size(); ++k) {
      queries[k] = {slot_[begin + k], counts[k], to};
      to += counts[k];
    }
    // Those of one cell search the same cells.
    std::ranges::sort(queries, {}, &CellGrid::Query::slot);
    grid_->find(queries);
    return;
  }
  std::vector<Found> found;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    tree_->within(static_cast<std::uint32_t>(begin + k), radius_ * radius_, found);
    for (const Found& f : found) *to++ = f.index;
  }
}

}  // namespace deburr

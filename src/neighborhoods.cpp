// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/neighborhoods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "cell_grid.hpp"
#include "columns.hpp"
#include "deburr/error.hpp"
#include "kd_tree.hpp"
#include "nearest_beside.hpp"
#include "neighbor_search.hpp"
#include "parallel.hpp"

namespace deburr {

Neighborhoods::Neighborhoods(std::vector<std::size_t> offsets, std::vector<std::uint32_t> indices)
    : offsets_(std::move(offsets)), indices_(std::move(indices)) {
  const bool partition = offsets_.empty()
                             ? indices_.empty()
                             : offsets_.front() == 0 && offsets_.back() == indices_.size() &&
                                   std::is_sorted(offsets_.begin(), offsets_.end());
  if (!partition) throw std::invalid_argument("neighborhoods.offsets do not partition the indices");
}

std::string too_many_pairs(std::size_t points, double radius, std::size_t pairs) {
  return fmt::format(
      "the neighbourhoods of {} points within a radius of {} hold {} pairs, more than the {} that "
      "are allowed",
      points, radius, pairs, max_pairs);
}

namespace {

constexpr double counted = 0.3;  ///< share of the progress that counting takes

/// Turns numbers of neighbours, each one place after its own, into offsets.
/// @throws DataError  if there are too many
void make_offsets(std::vector<std::size_t>& offsets, double radius) {
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  if (offsets.back() > max_pairs) {
    throw DataError(too_many_pairs(offsets.size() - 1, radius, offsets.back()));
  }
}

/// Room for all neighbours, filled step by step: that may take long.
std::vector<std::uint32_t> make_indices(std::size_t count, const Execution& execution) {
  constexpr std::size_t step = std::size_t{1} << 22;
  std::vector<std::uint32_t> indices;
  reserve_column(indices, count, execution);
  while (indices.size() < count) {
    check_cancelled(execution);
    indices.resize(std::min(count, indices.size() + step));
  }
  return indices;
}

// Counting first tells what memory is needed before any is taken.

Neighborhoods search_grid(const CellGrid& grid, const NeighborOptions& options,
                          const Execution& execution) {
  const std::size_t most =
      options.max_count > 0 ? options.max_count : std::numeric_limits<std::size_t>::max();
  auto offsets = make_column<std::size_t>(grid.size() + 1, execution);
  parallel_blocks(grid.size(), sub_execution(execution, "neighbourhoods", 0, counted),
                  [&](std::size_t begin, std::size_t end) {
                    std::vector<std::size_t> counts(end - begin);
                    grid.count(begin, end, counts.data());
                    for (std::size_t slot = begin; slot < end; ++slot) {
                      offsets[grid.index(slot) + 1] = std::min(counts[slot - begin], most);
                    }
                  });
  make_offsets(offsets, options.radius);
  std::vector<std::uint32_t> indices = make_indices(offsets.back(), execution);
  parallel_blocks(grid.size(), sub_execution(execution, "neighbourhoods", counted, 1),
                  [&](std::size_t begin, std::size_t end) {
                    std::vector<CellGrid::Query> queries(end - begin);
                    for (std::size_t slot = begin; slot < end; ++slot) {
                      const std::size_t offset = offsets[grid.index(slot)];
                      const std::size_t wanted = offsets[grid.index(slot) + 1] - offset;
                      queries[slot - begin] = {static_cast<std::uint32_t>(slot),
                                               static_cast<std::uint32_t>(wanted),
                                               indices.data() + offset};
                    }
                    grid.find(queries);
                  });
  return {std::move(offsets), std::move(indices)};
}

Neighborhoods search_tree(Points points, const NeighborOptions& options,
                          const Execution& execution) {
  const KdTree tree(points, execution);
  const double squared_radius = options.radius > 0 ? options.radius * options.radius
                                                   : std::numeric_limits<double>::infinity();
  const auto find = [&](std::size_t i, NearestBeside& nearest, std::vector<Found>& found) {
    const auto query = static_cast<std::uint32_t>(i);
    if (options.max_count > 0 && options.radius == 0) {
      nearest.find(tree, points[i], options.max_count, found, query);
    } else if (options.max_count > 0) {
      tree.nearest(query, options.max_count, squared_radius, found);
    } else {
      tree.within(query, squared_radius, found);
    }
  };

  const auto count = [&](std::size_t i) {
    const std::size_t all = options.radius > 0
                                ? tree.count_within(static_cast<std::uint32_t>(i), squared_radius)
                                : points.size() - 1;
    return options.max_count > 0 ? std::min(all, options.max_count) : all;
  };

  // Along the leaves of the tree one search warms the cache for the next.
  const std::vector<std::uint32_t>& order = tree.order();
  auto offsets = make_column<std::size_t>(points.size() + 1, execution);
  parallel_for(points.size(), sub_execution(execution, "neighbourhoods", 0, counted),
               [&](std::size_t at) { offsets[order[at] + 1] = count(order[at]); });
  make_offsets(offsets, options.radius);
  std::vector<std::uint32_t> indices = make_indices(offsets.back(), execution);
  parallel_blocks(points.size(), sub_execution(execution, "neighbourhoods", counted, 1),
                  [&](std::size_t begin, std::size_t end) {
                    NearestBeside nearest;
                    nearest.expect(tree.along_leaves().subspan(begin, end - begin));
                    std::vector<Found> found;
                    for (std::size_t at = begin; at < end; ++at) {
                      const std::size_t i = order[at];
                      find(i, nearest, found);
                      for (std::size_t k = 0; k < found.size(); ++k) {
                        indices[offsets[i] + k] = found[k].index;
                      }
                    }
                  });
  return {std::move(offsets), std::move(indices)};
}

}  // namespace

Neighborhoods find_neighbors(Points points, const NeighborOptions& options,
                             const Execution& execution) {
  if (!(options.radius >= 0) || !(options.radius <= std::numeric_limits<double>::max())) {
    throw std::invalid_argument(
        fmt::format("neighbors.radius must be finite and >= 0, got {}", options.radius));
  }
  if (options.max_count == 0 && options.radius == 0) {
    throw std::invalid_argument("neighbors.max_count and neighbors.radius must not both be 0");
  }
  if (points.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument(
        fmt::format("points must be fewer than 2^32, got {}", points.size()));
  }
  const auto bad = std::find_if_not(points.begin(), points.end(), is_finite);
  if (bad != points.end()) {
    throw std::invalid_argument(
        fmt::format("points[{}] is not finite", std::distance(points.begin(), bad)));
  }

  if (options.radius > 0) {
    if (const auto grid = CellGrid::make(points, options.radius, options.max_count,
                                         without_progress(execution))) {
      return search_grid(*grid, options, execution);
    }
  }
  return search_tree(points, options, execution);
}

double mean_neighbor_distance(Points points, const Neighborhoods& neighborhoods,
                              const Execution& execution) {
  if (points.size() != neighborhoods.size()) {
    throw std::invalid_argument(fmt::format("points and neighborhoods differ in size: {} and {}",
                                            points.size(), neighborhoods.size()));
  }
  if (neighborhoods.pair_count() == 0) return 0;
  const double sum = parallel_sum(points.size(), execution, [&](std::size_t i) {
    double distances = 0;
    for (const std::uint32_t j : neighborhoods[i]) distances += norm(points[j] - points[i]);
    return distances;
  });
  return sum / static_cast<double>(neighborhoods.pair_count());
}

}  // namespace deburr

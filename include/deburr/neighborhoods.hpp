// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Which other points count as neighbours of a point. At least one of the two must be given; with
/// both, the nearest `max_count` of those within `radius`.
struct NeighborOptions {
  std::size_t max_count = 0;  ///< at most so many, the nearest; 0 = no limit
  double radius = 0;          ///< no farther than this (inclusive), in input units; 0 = no limit
};

/// The neighbours of every point: flat offsets and indices. Those of a point do not include the
/// point itself and are sorted by (distance, index), which makes them unique.
class Neighborhoods {
 public:
  Neighborhoods() = default;
  /// @param offsets  size() + 1 ascending entries, the first 0
  /// @param indices  neighbours of point i at [offsets[i], offsets[i+1])
  /// @throws std::invalid_argument  if the offsets do not partition the indices
  Neighborhoods(std::vector<std::size_t> offsets, std::vector<std::uint32_t> indices);

  /// Number of points.
  [[nodiscard]] std::size_t size() const { return offsets_.empty() ? 0 : offsets_.size() - 1; }
  /// Number of neighbours of all points together.
  [[nodiscard]] std::size_t pair_count() const { return indices_.size(); }
  /// Neighbours of point i, nearest first.
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {indices_.data() + offsets_[i], offsets_[i + 1] - offsets_[i]};
  }

 private:
  std::vector<std::size_t> offsets_;
  std::vector<std::uint32_t> indices_;
};

/// Finds the neighbours of every point, exactly: within a radius with a grid of cells where that
/// pays, else with a k-d tree.
///
/// A cloud with fewer than max_count + 1 points gives every point all the others. Duplicates are
/// neighbours at distance 0.
///
/// @throws std::invalid_argument  if neither limit is given, the radius is negative or not finite,
///                    a point is not finite, or there are 2^32 points or more
/// @throws DataError  if the neighbourhoods would hold more than `max_pairs` indices (16 GiB)
[[nodiscard]] Neighborhoods find_neighbors(Points points, const NeighborOptions& options,
                                           const Execution& execution = {});

/// Largest number of indices that find_neighbors will hold.
inline constexpr std::size_t max_pairs = std::size_t{1} << 32;

/// Mean distance from a point to its neighbours, over all points and all their neighbours, in
/// input units: the "dbar" of Yadav et al. 2018 when every point has its k = 12 nearest.
/// 0 when no point has a neighbour.
[[nodiscard]] double mean_neighbor_distance(Points points, const Neighborhoods& neighborhoods,
                                            const Execution& execution = {});

}  // namespace deburr

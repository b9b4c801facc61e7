// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cell_grid.hpp"
#include "kd_tree.hpp"

namespace deburr {

/// What is wrong with so many neighbours.
std::string too_many_pairs(std::size_t points, double radius, std::size_t pairs);

/// All neighbours within one radius, of any run of points: as find_neighbors finds them, for those
/// who want them part by part.
class NeighborSearch {
 public:
  /// @param radius  > 0
  NeighborSearch(Points points, double radius, const Execution& execution);

  /// How many neighbours each point has.
  /// @throws DataError  if all together have more than find_neighbors allows
  [[nodiscard]] std::vector<std::uint32_t> count_all(const Execution& execution) const;

  /// Writes the neighbours of the points from `begin` on, one list after the other.
  /// @param counts  how many each of them has
  void find(std::size_t begin, std::span<const std::uint32_t> counts, std::uint32_t* to) const;

 private:
  Points points_;
  double radius_;
  std::optional<CellGrid> grid_;
  std::vector<std::uint32_t> slot_;  ///< of each point in the grid
  std::unique_ptr<KdTree> tree_;     ///< where there is no grid
};

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "distance_sort.hpp"

namespace deburr {

/// The points of a cloud sorted into cubes of a grid, for searches within one radius that is known
/// beforehand. Exact: finds what `KdTree::within` finds, in the same order.
///
/// A cube is one radius wide. Cubes along x stand next to each other in memory, so that a search
/// reads at most nine runs of points, eight points at a time.
class CellGrid {
 public:
  /// A grid over finite points, or none where it would not pay: where the cubes would be many more
  /// than the points, or a search would meet many more points than the `max_count` nearest that
  /// are wanted (0 for all).
  static std::optional<CellGrid> make(Points points, double radius, std::size_t max_count,
                                      const Execution& execution);

  /// Number of points.
  [[nodiscard]] std::size_t size() const { return index_.size(); }
  /// Index of the point in slot `slot`: near slots are near in space.
  [[nodiscard]] std::uint32_t index(std::size_t slot) const { return index_[slot]; }

  /// For each slot in [begin, end), how many other points are within the radius.
  void count(std::size_t begin, std::size_t end, std::size_t* counts) const;

  /// A slot, how many of its neighbours are wanted, and where they are written.
  struct Query {
    std::uint32_t slot, wanted;
    std::uint32_t* to;
  };
  /// Writes the wanted number of nearest other points within the radius, sorted by (distance,
  /// index). There are as many. Slots of one cell should follow each other.
  void find(std::span<const Query> queries) const;

 private:
  struct Axis {
    double low = 0;
    std::uint32_t cells = 1;
  };
  struct Runs;

  CellGrid() = default;
  void sort_points(Points points, const Execution& execution);
  [[nodiscard]] double squared_occupancy() const;  ///< pairs of points of one cell
  [[nodiscard]] std::uint32_t along(double v, const Axis& axis) const;  ///< cell of a coordinate
  void set_runs(std::size_t slot, Runs& runs) const;
  void find_one(std::size_t slot, std::size_t wanted, std::uint32_t* to, Runs& runs,
                DistanceSort& sort) const;

  double squared_radius_ = 0;
  double per_cell_ = 0;  ///< 1 / width of a cell
  std::array<Axis, 3> axes_;
  std::vector<std::uint32_t> begins_;  ///< first slot of each cell, and the end of the last
  std::vector<double> x_, y_, z_;      ///< by slot, with a few more that are read but never used
  std::vector<std::uint32_t> index_;   ///< by slot
};

}  // namespace deburr

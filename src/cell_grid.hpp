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
#include "kd_tree.hpp"

namespace deburr {

/// A cell is by so much wider than the radius, that rounding cannot move a neighbour
/// beyond the cells that are searched: coordinates in cells are off by less than
/// 3 * 2^-53 * most_along < 1e-9.
inline constexpr double cell_excess = 1e-6;

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

  /// For few: writes for each slot in [begin, end) the `count` nearest other points to
  /// `to[(slot - begin) * count]`, sorted by (distance, index). Where there are fewer within the
  /// radius, the rest is infinitely far.
  void nearest(std::size_t begin, std::size_t end, std::size_t count, Found* to) const;

  /// The points within the radius of a finite place, in an order that follows from it, put into the
  /// cleared `found`.
  void within_of(const Vec3& at, std::vector<Found>& found) const;

 private:
  struct Axis {
    double low = 0;
    std::uint32_t cells = 1;
  };
  /// The runs of slots in which the neighbours of a place in one cell are.
  struct Runs {
    struct Run {
      std::uint32_t begin, end;
      double y, z;  ///< of the row of cells, in cells
    };
    std::array<Run, 9> runs;
    std::size_t count = 0;
    std::uint64_t cell = ~std::uint64_t{0};
    std::size_t candidates = 0;
  };
  /// What a search has found: the first of the entries, with room for more.
  struct Space {
    double* squared_distances;
    std::uint32_t* indices;
  };

  CellGrid() = default;
  void sort_points(Points points, const Execution& execution);
  [[nodiscard]] double squared_occupancy() const;  ///< pairs of points of one cell
  [[nodiscard]] Vec3 place(std::size_t slot) const { return {x_[slot], y_[slot], z_[slot]}; }
  void set_runs(const Vec3& at, Runs& runs) const;
  [[nodiscard]] std::size_t gather(const Vec3& at, const Runs& runs, const Space& space) const;

  double squared_radius_ = 0;
  double per_cell_ = 0;  ///< 1 / width of a cell
  std::array<Axis, 3> axes_;
  std::vector<std::uint32_t> begins_;  ///< first slot of each cell, and the end of the last
  std::vector<double> x_, y_, z_;      ///< by slot, with a few more that are read but never used
  std::vector<std::uint32_t> index_;   ///< by slot
};

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "box.hpp"
#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// A neighbour found by a search. The order (distance, index) makes results unique.
struct Found {
  double squared_distance;
  std::uint32_t index;

  friend bool operator<(const Found& a, const Found& b) {
    if (a.squared_distance != b.squared_distance) return a.squared_distance < b.squared_distance;
    return a.index < b.index;
  }
};

/// A tree of boxes over points that are all finite. Which points a search finds, and in which
/// order, is defined by (distance, index) alone.
class KdTree {
 public:
  /// No point has this index, since there are fewer than 2^32.
  static constexpr std::uint32_t no_point = std::numeric_limits<std::uint32_t>::max();

  explicit KdTree(Points points, const Execution& execution = {.threads = 1});

  /// The `count` nearest other points of point `query` no farther than sqrt(squared_radius),
  /// appended to the cleared `found` in ascending order.
  void nearest(std::uint32_t query, std::size_t count, double squared_radius,
               std::vector<Found>& found) const;

  /// All other points of point `query` no farther than sqrt(squared_radius), likewise.
  void within(std::uint32_t query, double squared_radius, std::vector<Found>& found) const;

  /// The `count` points nearest to a finite place no farther than sqrt(squared_radius), likewise;
  /// point `excluded`, if there is such a point, is left out.
  void nearest_to(const Vec3& at, std::size_t count, double squared_radius,
                  std::vector<Found>& found, std::uint32_t excluded = no_point) const;

  /// The nearest point of a finite place. The tree must hold at least one point.
  [[nodiscard]] Found nearest_to(const Vec3& at) const;

  /// All points of a finite place no farther than sqrt(squared_radius), likewise.
  void within_of(const Vec3& at, double squared_radius, std::vector<Found>& found) const;

  /// Number of points that within() finds; does not visit points of boxes wholly inside.
  [[nodiscard]] std::size_t count_within(std::uint32_t query, double squared_radius) const;

  /// A run of points along the leaves: positions in order().
  struct Run {
    std::uint32_t begin, end;
  };

  /// Appends runs to the cleared `runs` that together hold every point no farther than
  /// sqrt(squared_radius) from a finite place, and others of the same leaves.
  void runs_within(const Vec3& at, double squared_radius, std::vector<Run>& runs) const;

  /// Indices of the points along the leaves: near in this order means near in space.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  /// The points in that order.
  [[nodiscard]] Points along_leaves() const { return sorted_; }
  /// Begins of the largest nodes of at most `most` points, >= 1, in that order, parts of leaves
  /// among them; ends with the number of points.
  [[nodiscard]] std::vector<std::uint32_t> groups(std::size_t most) const;

 private:
  /// A node owns order_[begin, end), which its children, if any, split.
  struct Node {
    Box box;
    std::uint32_t begin, end;
    std::uint32_t right;     ///< index of the right child, the left one is next; 0 for a leaf
    std::uint32_t smallest;  ///< smallest index of a point in here
  };

  /// `excluded` is the index of a point that is not to be found.
  void nearest(const Vec3& at, std::uint32_t excluded, std::size_t count, double squared_radius,
               std::vector<Found>& found) const;
  void within(const Vec3& at, std::uint32_t excluded, double squared_radius,
              std::vector<Found>& found) const;
  void add_runs(std::uint32_t node, const Vec3& at, double squared_radius,
                std::vector<Run>& runs) const;
  template <typename Visit>
  void search(std::uint32_t node, const Vec3& at, const Found& limit, const Visit& visit) const;

  Points points_;
  std::vector<std::uint32_t> order_;
  std::vector<Vec3> sorted_;  ///< points_ along order_, to be read in one go
  std::vector<Node> nodes_;
};

}  // namespace deburr

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

/// A balanced k-d tree over points that are all finite. Which points a search finds, and in which
/// order, is defined by (distance, index) alone.
class KdTree {
 public:
  /// No point has this index, since there are fewer than 2^32.
  static constexpr std::uint32_t no_point = std::numeric_limits<std::uint32_t>::max();

  explicit KdTree(Points points, const Execution& execution = {});

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

  /// As nearest_to() without a radius, for places that follow each other closely: how far one
  /// search had to go, `hint`, limits the next, which is done again where that was not enough.
  /// @param hint  infinity at first; does not change what is found
  void nearest_beside(const Vec3& at, std::size_t count, double& hint, std::vector<Found>& found,
                      std::uint32_t excluded = no_point) const;

  /// The nearest point of a finite place. The tree must hold at least one point.
  [[nodiscard]] Found nearest_to(const Vec3& at) const;

  /// All points of a finite place no farther than sqrt(squared_radius), likewise.
  void within_of(const Vec3& at, double squared_radius, std::vector<Found>& found) const;

  /// Number of points that within() finds; does not visit points of boxes wholly inside.
  [[nodiscard]] std::size_t count_within(std::uint32_t query, double squared_radius) const;

  /// Indices of the points along the leaves: near in this order means near in space.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

 private:
  /// A node owns order_[begin, end); its children, if any, split that at the middle.
  struct Node {
    Box box;
    std::uint32_t begin, end;
    std::uint32_t right;     ///< index of the right child, the left one is next; 0 for a leaf
    std::uint32_t smallest;  ///< smallest index of a point in here
  };

  /// Points of `order_` that are to become a node.
  struct Range {
    std::uint32_t begin, end;
    std::uint32_t node;
  };

  void build_all(const Execution& execution);
  void build(const Range& range, const Execution& execution);
  /// Makes one node. Returns its children, without points where it has none.
  std::array<Range, 2> split(const Range& range, const Execution& execution);
  /// `excluded` is the index of a point that is not to be found.
  void nearest(const Vec3& at, std::uint32_t excluded, std::size_t count, double squared_radius,
               std::vector<Found>& found) const;
  void within(const Vec3& at, std::uint32_t excluded, double squared_radius,
              std::vector<Found>& found) const;
  template <typename Visit>
  void search(std::uint32_t node, const Vec3& at, const Found& limit, const Visit& visit) const;

  Points points_;
  std::vector<std::uint32_t> order_;
  std::vector<Vec3> sorted_;  ///< points_ along order_, to be read in one go
  std::vector<Node> nodes_;
};

}  // namespace deburr

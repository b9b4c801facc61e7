// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "columns.hpp"
#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "kd_tree.hpp"

namespace deburr {

/// Some of the points of a k-d tree, to search among without a tree of their own.
class SomePoints {
 public:
  /// Stands for a point that is left out.
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// All of them.
  SomePoints(Points points, const KdTree& tree) : points_(points), tree_(tree) {}
  /// @param kept  whether each point of the tree is one of them; as long as there are points
  template <typename Kept>
  SomePoints(Points points, const KdTree& tree, const Kept& kept, const Execution& execution);

  SomePoints(const SomePoints&) = delete;  // points_ may be its own
  SomePoints& operator=(const SomePoints&) = delete;

  /// In the order of the tree's points, by which they are known from here on.
  [[nodiscard]] Points points() const { return points_; }
  /// What the point of the tree is known by, or none.
  [[nodiscard]] std::uint32_t place(std::uint32_t point) const {
    return places_.empty() ? point : places_[point];
  }
  /// They along the leaves of the tree.
  [[nodiscard]] std::span<const std::uint32_t> order() const {
    return places_.empty() ? std::span(tree_.order()) : std::span(order_);
  }
  /// Begins of groups of at most `most` in the order, those of KdTree::groups(), none empty; ends
  /// with the number of points.
  [[nodiscard]] std::vector<std::uint32_t> groups(std::size_t most) const;
  /// The `count` nearest to a finite place, as KdTree::nearest_to().
  void nearest_to(const Vec3& at, std::size_t count, std::vector<Found>& found) const;

 private:
  Points points_;
  const KdTree& tree_;
  std::vector<Vec3> own_;
  std::vector<std::uint32_t> places_;  ///< empty where all are there
  std::vector<std::uint32_t> order_;
};

template <typename Kept>
SomePoints::SomePoints(Points points, const KdTree& tree, const Kept& kept,
                       const Execution& execution)
    : points_(points), tree_(tree) {
  bool all = false;
  const auto make_room = [&](std::size_t count) {
    all = count == points.size();
    if (all) return;
    places_.assign(points.size(), none);
    resize_column(own_, count, execution);
    resize_column(order_, count, execution);
  };
  const auto put = [&](std::size_t i, std::size_t place) {
    if (all) return;
    places_[i] = static_cast<std::uint32_t>(place);
    own_[place] = points[i];
  };
  pick(points.size(), kept, make_room, put, execution);
  if (all) return;
  const std::vector<std::uint32_t>& order = tree.order();
  pick(
      order.size(), [&](std::size_t at) { return places_[order[at]] != none; }, [](std::size_t) {},
      [&](std::size_t at, std::size_t k) { order_[k] = places_[order[at]]; }, execution);
  points_ = own_;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "found_sort.hpp"
#include "kd_tree.hpp"

namespace deburr {

/// Searches for the nearest points of places that follow each other closely. Exact: finds what
/// KdTree::nearest_to() finds, whatever was asked before.
///
/// The points of a ball around one place are copied out of the tree, and looked through eight at a
/// time for as many of the places that follow as the ball is large enough for. Its radius, and the
/// distance up to which points are sorted, follow from the search before.
class NearestBeside {
 public:
  /// Tells around which places searches will be, in their order; some may be left out. Balls lie
  /// around many of them then. Does not change what is found. A place must not change before
  /// its search.
  void expect(Points places) { expected_ = places; }

  /// The `count` points nearest to a finite place, appended to the cleared `found` in ascending
  /// order; point `excluded`, if there is such a point, is left out.
  /// @param tree  the same each time
  void find(const KdTree& tree, const Vec3& at, std::size_t count, std::vector<Found>& found,
            std::uint32_t excluded = KdTree::no_point);

 private:
  [[nodiscard]] bool find_in_ball(const KdTree& tree, const Vec3& at, std::size_t count,
                                  std::vector<Found>& found, std::uint32_t excluded);
  [[nodiscard]] bool gather(const KdTree& tree, const Vec3& at, std::size_t count);
  void center_ball(const Vec3& at);
  [[nodiscard]] double safe_square(const Vec3& at) const;
  [[nodiscard]] bool select(const Vec3& at, std::size_t count, double safe);
  void sort(std::size_t count, std::vector<Found>& found);

  // The ball. Columns have room for whole lanes, and far values in what is too much.
  Vec3 center_;
  double radius_ = -1;  ///< all points up to here are in the columns; < 0 without a ball
  std::size_t size_ = 0;
  std::vector<double> x_, y_, z_;
  std::vector<std::uint32_t> index_;
  std::vector<KdTree::Run> runs_;

  Points expected_;  ///< what is left of them

  // Of the search before.
  std::size_t count_ = 0;
  double square_ = 0;         ///< of the distance to the last that was found; 0 if unknown
  std::size_t patience_ = 0;  ///< so many searches go without a ball, since there was none

  // Of this search.
  std::vector<double> squares_;
  std::vector<double> keys_;  ///< squares with the place in the columns in their last bits
  std::vector<double> near_;  ///< keys of those that may be among the nearest
  std::size_t near_count_ = 0;
};

}  // namespace deburr

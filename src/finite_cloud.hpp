// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "kd_tree.hpp"
#include "require.hpp"

namespace deburr {

/// Some points of a cloud, all finite, and a tree over them.
class FiniteCloud {
 public:
  /// Keeps the points i that are finite and for which keep(i) is true.
  template <typename Keep>
  FiniteCloud(Points points, const Execution& execution, const Keep& keep)
      : indices_(finite(points, keep)), points_(at(points, indices_)), tree_(points_, execution) {}
  FiniteCloud(Points points, const Execution& execution)
      : FiniteCloud(points, execution, [](std::uint32_t) { return true; }) {}
  FiniteCloud(const FiniteCloud&) = delete;  // the tree looks at points_
  FiniteCloud& operator=(const FiniteCloud&) = delete;

  [[nodiscard]] bool empty() const { return points_.empty(); }
  [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }
  /// What a search in the tree calls i is this point of the cloud.
  [[nodiscard]] std::uint32_t original(std::uint32_t i) const { return indices_[i]; }
  [[nodiscard]] const KdTree& tree() const { return tree_; }

 private:
  template <typename Keep>
  static std::vector<std::uint32_t> finite(Points points, const Keep& keep) {
    require(points.size() <= std::numeric_limits<std::uint32_t>::max(), "points", "fewer than 2^32",
            points.size());
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if (is_finite(points[i]) && keep(i)) indices.push_back(i);
    }
    return indices;
  }
  static std::vector<Vec3> at(Points points, const std::vector<std::uint32_t>& indices) {
    std::vector<Vec3> kept;
    kept.reserve(indices.size());
    for (const std::uint32_t i : indices) kept.push_back(points[i]);
    return kept;
  }

  std::vector<std::uint32_t> indices_;
  std::vector<Vec3> points_;
  KdTree tree_;
};

}  // namespace deburr

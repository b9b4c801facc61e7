// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "kd_tree.hpp"
#include "surface_nodes.hpp"

namespace deburr {

/// Resolutions that sheets are fitted over: level 0 has all nodes, every other one fewer.
inline constexpr std::size_t node_levels = 3;

/// One surface as nodes at several resolutions, so that a fit over a large part of it need not
/// visit more of them than one over a small part.
class NodeLevels {
 public:
  /// @param fine  the nodes of level 0
  /// @param spacing  of them
  /// @param noise  standard deviation: cells of the other levels are no smaller
  NodeLevels(SurfaceNodes fine, double spacing, double noise, const Execution& execution = {});

  // The trees look at the nodes: a copy would look at those of another.
  NodeLevels(const NodeLevels&) = delete;
  NodeLevels& operator=(const NodeLevels&) = delete;
  ~NodeLevels() = default;

  [[nodiscard]] const SurfaceNodes& nodes(std::size_t level) const { return nodes_[level]; }
  [[nodiscard]] const KdTree& tree(std::size_t level) const { return trees_[level]; }
  /// The nodes of level 0, at the end of all else.
  [[nodiscard]] SurfaceNodes take_nodes() && { return std::move(nodes_[0]); }
  [[nodiscard]] double spacing() const { return spacing_; }
  /// Mean number of nodes of level 0 in one of this level.
  [[nodiscard]] double merged(std::size_t level) const {
    return static_cast<double>(nodes_[0].size()) / static_cast<double>(nodes_[level].size());
  }

 private:
  std::vector<SurfaceNodes> nodes_;
  std::vector<KdTree> trees_;
  double spacing_;
};

}  // namespace deburr

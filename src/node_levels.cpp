// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "node_levels.hpp"

#include <algorithm>

namespace deburr {
namespace {

/// Side of a cell of one level, in that of the level before, or the spacing of the nodes.
constexpr double coarsening = 3;

/// Cells are large enough for several sheets, so normals are told apart to about 30 degrees.
constexpr std::uint32_t normal_bins = 3;

}  // namespace

NodeLevels::NodeLevels(SurfaceNodes fine, double spacing, double noise, const Execution& execution)
    : spacing_(spacing) {
  nodes_.reserve(node_levels);
  trees_.reserve(node_levels);
  nodes_.push_back(std::move(fine));
  trees_.emplace_back(nodes_[0].places, execution);
  double cell = spacing;
  for (std::size_t level = 1; level < node_levels; ++level) {
    cell = std::max(coarsening * cell, noise);
    const SurfaceNodes& all = nodes_[level - 1];
    nodes_.push_back(merge_into_cells(all.measured, all.places, all.normals, all.weights, all.trust,
                                      cell, normal_bins, execution));
    trees_.emplace_back(nodes_[level].places, execution);
  }
}

}  // namespace deburr

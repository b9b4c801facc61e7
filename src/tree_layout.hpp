// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// A binary tree over points, as ranges of an order of theirs.
struct TreeLayout {
  /// Children, if any, split the range of their parent.
  struct Range {
    std::uint32_t begin, end;
    std::uint32_t right;  ///< index of the right child, the left one is next; 0 for a leaf
  };
  std::vector<std::uint32_t> order;
  std::vector<Range> ranges;  ///< the root first
};

/// Sorts points along a Z-order curve of 1024 cells a side and splits them where it goes from one
/// of the largest cells to the next, but not too far from the middle: after Lauterbach et al., Fast
/// BVH construction on GPUs, 2009, section 3. What is too dense for these cells gets finer ones of
/// its own. Takes time in proportion to the number of points, unlike a search for medians, and
/// boxes around the ranges hardly overlap.
/// @param points  finite
/// @param most  points of a leaf, >= 1. More than that are split in any case, those at one place by
///              index.
[[nodiscard]] TreeLayout lay_out_tree(Points points, std::uint32_t most,
                                      const Execution& execution);

}  // namespace deburr

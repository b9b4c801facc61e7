// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "kd_tree.hpp"

namespace deburr {

/// What the group of a point says of it.
enum class Standing : std::uint8_t {
  Surface,  ///< in a large group
  Patch,    ///< in a small group that is as flat as a piece of surface
  Loose     ///< alone or in another small group
};

/// Joins points into groups.
///
/// The reach of a point is its distance to the 6th nearest other point. A point is joined with
/// those of its 6 nearest whose reach differs from its own by a factor of 2 at most: neither a lone
/// point with the surface it is off, nor a tight cluster with what lies far outside it, whatever
/// the density of either. Points of more than three times the reach that nine tenths of the points
/// have at most are joined with nothing, since scattered points would all hang together.
///
/// @param points  distinct, more than 6
/// @param small   points of a small group, at most
[[nodiscard]] std::vector<Standing> join_points(Points points, const KdTree& tree,
                                                std::size_t small, const Execution& execution);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "near_lists.hpp"

namespace deburr {

/// The points of a sweep in place in another order, with the same result to the last bit: of two
/// neighbours, the one that was first still is. In this order points come in batches of up to eight
/// that are no neighbours of each other, and one batch is near the next.
struct SweepPlan {
  std::vector<std::uint32_t> order;  ///< the points, batch after batch
  std::vector<std::uint32_t> ends;   ///< where in `order` each batch ends
};

/// Plans a sweep over all points.
/// @param lists  mutual: if i is a neighbour of j, then j is one of i. Points of one of its blocks
/// are
///               looked at together, as long as one of them can go.
/// @param order  a permutation of the points
/// @throws Cancelled  when execution.cancelled says so
SweepPlan plan_sweep(const NearLists& lists, std::span<const std::uint32_t> order,
                     const Execution& execution = {});

}  // namespace deburr

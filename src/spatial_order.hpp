// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "columns.hpp"
#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Indices of the points along a Morton curve through their bounding box: near in this order means
/// near in space, and mostly near in memory. Points at the same place stand together, by index;
/// otherwise the order depends on the positions alone, not on the order that they come in.
/// @pre all points are finite and fewer than 2^32
std::vector<std::uint32_t> spatial_order(Points points, const Execution& execution);

/// values[order[0]], values[order[1]], ...
template <typename Value>
std::vector<Value> gather(std::span<const Value> values, std::span<const std::uint32_t> order,
                          const Execution& execution = {.threads = 1}) {
  auto gathered = make_column<Value>(order.size(), execution);
  parallel_for(order.size(), without_progress(execution),
               [&](std::size_t i) { gathered[i] = values[order[i]]; });
  return gathered;
}

}  // namespace deburr

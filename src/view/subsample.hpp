// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr::view {

/// The numbers 0 to count - 1 in the order of their reversed binary digits: every beginning of it
/// is spread evenly over the whole.
[[nodiscard]] std::vector<std::uint32_t> progressive_order(std::uint32_t count);

/// At most `count` of the candidates, spread evenly: every n-th along a Morton curve, so that dense
/// regions stay denser than others. They come in an order of which every beginning is spread evenly
/// too, so that a viewer may draw any first part. Depends on the places of the points, not on
/// their order.
///
/// @param points      all of the cloud
/// @param candidates  indices of the points that may be chosen, which must be finite
[[nodiscard]] std::vector<std::uint32_t> even_subsample(Points points,
                                                        std::span<const std::uint32_t> candidates,
                                                        std::size_t count,
                                                        const Execution& execution = {});

}  // namespace deburr::view

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "kd_tree.hpp"

namespace deburr {

/// Standard deviation of the heights over patches of `count` points about the places, also of those
/// points that are too far off for the patch to count them: impulsive noise. `sigma` where there
/// are hardly any on both sides of the surface.
/// @param sigma  standard deviation that the patches themselves show
double with_tails(Points points, const KdTree& tree, std::span<const Vec3> places,
                  std::size_t count, double sigma, const Execution& execution);

}  // namespace deburr

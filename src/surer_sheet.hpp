// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "kd_tree.hpp"
#include "packed_sheet.hpp"

namespace deburr {

/// The sheet that stands for a point: that of its own node, unless there is none or it is far less
/// sure than those around. Then the normal that it was made with was none of a surface, and the
/// nearest sure sheet that the noise lets the point be of takes its place, if there is one. Sure is
/// what has at most three times the lower quartile of the variances around.
/// @param point  where it was measured
/// @param own  KdTree::no_point for none
/// @param near  sheets around it, nearest first, all valid
/// @param noise  standard deviation: a point is no farther than three times that from its sheet
std::uint32_t surer_sheet(const Vec3& point, std::uint32_t own, std::span<const Found> near,
                          std::span<const PackedSheet> sheets, double noise);

}  // namespace deburr

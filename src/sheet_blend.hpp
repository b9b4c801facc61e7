// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "kd_tree.hpp"
#include "packed_sheet.hpp"

namespace deburr {

/// A plane through the surface near a point, blended from the sheets around it.
struct Blend {
  Vec3 foot;    ///< where the point lands
  Vec3 normal;  ///< unit
  bool valid = false;
};

/// Lengths that tell which sheets are of one surface.
struct BlendScales {
  double noise = 0;
  double spacing = 0;
};

/// Moves a point onto the mean of the sheets near its place, each weighted by how near and how sure
/// it is, as far as they are of one smooth surface with its own sheet.
/// Source: aggregation of local estimates, Xu and Foi, TVCG 2019.
/// @param near  sheets near `place`, nearest first, all valid
/// @param own  the sheet of the point, valid
Blend blend_sheets(const Vec3& point, const Vec3& place, std::uint32_t own,
                   std::span<const Found> near, std::span<const PackedSheet> sheets,
                   const BlendScales& scales);

}  // namespace deburr

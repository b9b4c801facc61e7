// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "deburr/vec3.hpp"

namespace deburr {

/// A flat sheet near a point, cut off where it meets others.
struct CutSheet {
  Vec3 foot;         ///< of the point on the plane of the sheet
  Vec3 normal;       ///< unit
  double share = 1;  ///< how likely the point is of this sheet
};

/// How a sheet lies to another: +1 or -1, the side of its plane; 0 where it goes on past it.
using SideOf = double;

/// Sets the shares of up to three sheets that meet: for noise that is the same in all directions,
/// the likelihood that a point of sheet k is measured at x is that of its height over k times, for
/// every other sheet, that of its foot on k being measured there for a true foot on this side.
/// Fits with these weights have no bias at edges: where the sheets are right, the expected sum of
/// share times height is 0, while sorting each point to one sheet keeps the noise that points out of
/// an edge, and not that which points in.
/// Source: responsibilities of a mixture (Dempster, Laird, Rubin, 1977).
/// @param side  side[j][k] tells on which side of j the sheet k lies
/// @param noise  standard deviation, > 0
void set_shares(const Vec3& x, std::span<CutSheet> sheets, const SideOf side[3][3], double noise);

}  // namespace deburr

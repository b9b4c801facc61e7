// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "deburr/vec3.hpp"

namespace deburr {

/// A flat sheet near a point, cut off where it meets others.
struct CutSheet {
  Vec3 foot;         ///< of the point on the plane of the sheet
  Vec3 normal;       ///< unit
  double share = 1;  ///< how likely the point is of this sheet
};

inline constexpr double same_sheet = 0.9;     ///< cosine between normals of one sheet, at least
inline constexpr double other_sheet = 0.866;  ///< 30 degrees: below, two sheets meet in an edge

/// Sheets that one point may be of: three make a corner.
inline constexpr std::size_t most_sheets = 3;

/// The side of sheet j that sheet k lies on, at [j][k]: +1 or -1; 0 where it goes on past it.
using Sides = std::array<std::array<double, most_sheets>, most_sheets>;

/// Sets the shares of up to `most_sheets` sheets that meet: for noise that is the same in all
/// directions, the likelihood that a point of sheet k is measured at x is that of its height over k
/// times, for every other sheet, that of its foot on k being measured there for a true foot on this
/// side. Fits with these weights have no bias at edges: where the sheets are right, the expected
/// sum of share times height is 0, while sorting each point to one sheet keeps the noise that
/// points out of an edge, and not that which points in. Source: responsibilities of a mixture
/// (Dempster, Laird, Rubin, 1977).
/// @param noise  standard deviation, > 0
void set_shares(const Vec3& x, std::span<CutSheet> sheets, const Sides& side, double noise);

}  // namespace deburr

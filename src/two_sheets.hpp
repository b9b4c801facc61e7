// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "deburr/vec3.hpp"

namespace deburr {

/// Two parallel surfaces that the points of a patch may be of.
struct TwoSheets {
  double gap = 0;       ///< distance of the surfaces
  double variance = 0;  ///< of the heights about them, > 0
  double share = 0;     ///< of the points, on the smaller one
  /// Log-likelihood of two surfaces over that of one, both with normal noise.
  double gain = 0;
  /// How often points next to each other across the surface are of different sheets, over how often
  /// they would be by chance: about 1 where sheets lie over each other, little at a step.
  double mixing = 0;
  /// Density of the heights halfway between the surfaces over that at the surfaces: noise that is
  /// as likely everywhere within bounds has 1, and passes for two surfaces otherwise.
  double valley = 1;
};

/// Fits a quadric twice, at two heights, to points of which it is not known which is of which.
/// @param points  heights z over (x, y)
/// @param scale  a length that x and y are of the order of, > 0
/// All 0 where there are too few points, or where all lie on one quadric.
TwoSheets fit_two_sheets(std::span<const Vec3> points, double scale);

}  // namespace deburr

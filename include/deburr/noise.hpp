// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// The noise of a cloud, and lengths to compare it with. All in input units.
struct NoiseEstimate {
  double sigma = 0;    ///< standard deviation of the noise across the surface, >= 0
  double spacing = 0;  ///< square root of the area of the surface per point, >= 0
  double reach = 0;    ///< radius about a point within which noise can be told from surface, >= 0
  /// Distance of two sheets that lie over each other in most of the cloud, so close that they look
  /// like one with more noise; 0 where there is no evidence of them.
  double gap = 0;
};

/// Estimates the noise from the points alone: the variance about quadrics that are fitted to
/// patches of the smallest size that resolves it, over up to 4,096 places. See
/// docs/method/noise.md.
///
/// Points that are not finite do not count, and of those at the same place one does; which order
/// they come in does not matter. All three are 0 when fewer than 16 points are left. Where no patch
/// of up to a sixth of the cloud is as large as the noise, sigma is that of the largest, which can
/// be wrong either way.
[[nodiscard]] NoiseEstimate measure_noise(Points points, const Execution& execution = {});

/// measure_noise(points, execution).sigma
[[nodiscard]] double estimate_noise(Points points, const Execution& execution = {});

/// The noise of a cloud from place to place, in input units.
struct LocalNoise {
  NoiseEstimate overall;        ///< as of measure_noise
  std::vector<double> sigma;    ///< at each point; overall.sigma where nothing else is evident
  std::vector<double> spacing;  ///< at each point
};

/// Estimates noise and spacing at each point, for clouds in which they differ from place to place,
/// as where noise grows with the distance from the scanner. They vary smoothly, over about a
/// hundredth of the surface or ten patches, whatever is more. Differences of less than a fifth are
/// not believed. A point that is not finite has the overall values, and so have all where
/// overall.gap > 0.
[[nodiscard]] LocalNoise estimate_local_noise(Points points, const Execution& execution = {});

}  // namespace deburr

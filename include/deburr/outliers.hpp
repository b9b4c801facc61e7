// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// How readily find_outliers() flags. The default needs no change; scales are found from the cloud.
struct OutlierOptions {
  /// Multiplies every distance that a point may have from the surface, in [0.1, 10]: above 1 fewer
  /// points are flagged, below 1 more.
  double tolerance = 1;
};

/// Finds points that do not belong to the surface that the others sample: single ones, scattered
/// ones, and small groups of at most `most_floaters` points, however dense.
///
/// A point is flagged when its distance from the surface that is fitted to the points around it,
/// without itself, is more than the noise there explains. Noise and spacing are taken from the
/// cloud, from place to place.
///
/// @return one entry per point: 1 for an outlier, 0 for any other. Points that are not finite are
///         0; points at the same place have the same fate. All 0 when fewer than 64 distinct finite
///         points are there, too few to make out a surface.
/// @throws std::invalid_argument  for an option out of its range, or 2^32 points or more
[[nodiscard]] std::vector<std::uint8_t> find_outliers(Points points,
                                                      const OutlierOptions& options = {},
                                                      const Execution& execution = {});

/// Largest number of points in a group that can be off the surface as a whole.
inline constexpr std::size_t most_floaters = 128;

}  // namespace deburr

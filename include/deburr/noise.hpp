// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// The noise of a cloud, and lengths to compare it with. All in input units.
struct NoiseEstimate {
  double sigma = 0;    ///< standard deviation of the noise across the surface
  double spacing = 0;  ///< square root of the surface's area per distinct point
  double reach = 0;    ///< radius about a point within which the noise was told from the surface
};

/// Estimates the noise from the points alone.
[[nodiscard]] NoiseEstimate measure_noise(Points points, const Execution& execution = {});

/// measure_noise(points, execution).sigma
[[nodiscard]] double estimate_noise(Points points, const Execution& execution = {});

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "automatic.hpp"

namespace deburr {

/// Noise that differs from place to place, as a few values with a factor of 2 from each to the
/// next.
struct NoiseLevels {
  std::vector<double> sigma;  ///< to run the levels with, ascending; empty where it hardly differs
  /// Where each point lies between them: i + t is a share of 1 - t of level i and t of i + 1.
  std::vector<double> at;
};

/// @param local  standard deviation at each point, >= 0
/// @param least  no level is below this, > 0
NoiseLevels find_noise_levels(std::span<const double> local, double least);

/// The default method once for each level, over the points that are near it; what it makes of a
/// point at both levels next to it is averaged.
/// @param input  its noise and bound do not count
/// @param levels  at least one, for as many points as there are
/// @param bound  no point moves farther; where 0, so many standard deviations of a level:
/// @param deviations  > 0
AutomaticResult denoise_at_levels(const AutomaticInput& input, const NoiseLevels& levels,
                                  double bound, double deviations, StageClock& clock,
                                  const Execution& execution);

}  // namespace deburr

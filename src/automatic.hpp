// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "automatic_parts.hpp"
#include "deburr/execution.hpp"
#include "deburr/features.hpp"
#include "deburr/noise.hpp"
#include "stage_clock.hpp"

namespace deburr {

/// What the default method works on: distinct finite points without outliers.
struct AutomaticInput {
  Points points;
  Normals normals;      ///< to start from; zero where there is none, empty for none at all
  double noise = 0;     ///< standard deviation of the noise
  double spacing = 0;   ///< of the surface: square root of its area per point, > 0
  double max_move = 0;  ///< no point moves farther
  AutomaticParts parts{};
};

/// Whether points are merged into nodes: from here on neighbourhoods as wide as the noise hold more
/// of them than their number is worth.
inline bool is_dense(const AutomaticInput& input) { return input.noise > 0.5 * input.spacing; }

struct AutomaticResult {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<Feature> labels;
  bool kept_normals = false;  ///< whether it started from the normals of the input
};

/// The default method. See docs/method/automatic.md.
AutomaticResult denoise_automatically(const AutomaticInput& input, StageClock& clock,
                                      const Execution& execution);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/noise.hpp"

#include "noise_survey.hpp"

namespace deburr {

NoiseEstimate measure_noise(Points points, const Execution& execution) {
  NoiseSurvey survey(points, execution);
  const NoiseEstimate local = survey.overall(execution);
  const WorkingSet& set = survey.set();
  return {set.length(local.sigma), set.length(local.spacing), set.length(local.reach),
          set.length(local.gap)};
}

double estimate_noise(Points points, const Execution& execution) {
  return measure_noise(points, execution).sigma;
}

}  // namespace deburr

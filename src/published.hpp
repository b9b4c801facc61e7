// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "schedule.hpp"
#include "stage_clock.hpp"
#include "working_set.hpp"

namespace deburr {

/// The points on their way, in the coordinates of the working set.
struct State {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<Feature> labels;

  /// Every point where it was, of no surface.
  static State of(const WorkingSet& set) {
    const std::size_t n = set.points.size();
    return {set.points, std::vector<Vec3>(n), std::vector<Feature>(n, Feature::Isolated)};
  }
};

/// The rounds of the published method: filter the normals, classify the points, move them.
/// @param nearest  of each point, for the first normals
/// @param keep_normals  whether to start from those of the set
/// @param[in,out] report  gets what each round moved
void run_published(Neighborhoods nearest, const Schedule& schedule, const WorkingSet& set,
                   bool keep_normals, State& state, Report& report, StageClock& clock,
                   const Execution& execution);

}  // namespace deburr

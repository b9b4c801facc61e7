// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "deburr/execution.hpp"
#include "kd_tree.hpp"
#include "noise_statistics.hpp"
#include "patch_survey.hpp"
#include "working_set.hpp"

namespace deburr {

/// The distinct finite points of a cloud, and what patches of them show. Lengths are those of the
/// working set, in which no square overflows.
class NoiseSurvey {
 public:
  /// Of any points.
  NoiseSurvey(Points points, const Execution& execution);
  /// Of a set whose points are all different.
  NoiseSurvey(WorkingSet set, const Execution& execution);
  NoiseSurvey(const NoiseSurvey&) = delete;  // parts refer to each other
  NoiseSurvey& operator=(const NoiseSurvey&) = delete;

  /// Looks at patches of growing size until they resolve the noise.
  NoiseEstimate overall(const Execution& execution);

  /// Mean distance of points to the `k` nearest of the others, over some 4096 of them, evenly
  /// along the order of the set. 0 where there are no others.
  [[nodiscard]] double neighbor_distance(std::size_t k, const Execution& execution) const;

  [[nodiscard]] const WorkingSet& set() const { return set_; }
  [[nodiscard]] bool has_enough_points() const;
  [[nodiscard]] PatchSurvey& patches() { return patches_; }

 private:
  void add_size(const Execution& execution);
  /// About so many places, evenly out of the sample.
  [[nodiscard]] std::vector<Vec3> some_places(std::size_t number) const;
  [[nodiscard]] double whole_sigma(std::size_t count, double sigma,
                                   const Execution& execution) const;

  WorkingSet set_;
  KdTree tree_;
  PatchSurvey patches_;
  std::vector<SizeEstimate> sizes_;
};

}  // namespace deburr

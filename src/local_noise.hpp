// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/noise.hpp"
#include "kd_tree.hpp"
#include "noise_survey.hpp"
#include "working_set.hpp"

namespace deburr {

/// Noise and spacing of a cloud as a whole, at a sample of places, and at each point: what comes
/// later costs more and is only made where it is asked for. All in the unit of the cloud.
class LocalNoiseField {
 public:
  /// As NoiseSurvey.
  LocalNoiseField(Points points, const Execution& execution);
  LocalNoiseField(WorkingSet set, const Execution& execution);

  [[nodiscard]] const NoiseEstimate& overall() const { return overall_; }
  /// Mean distance of points to the `k` nearest of the others.
  [[nodiscard]] double neighbor_distance(std::size_t k, const Execution& execution) const;

  /// Standard deviation at places that the points are evenly divided among. Empty where nothing is
  /// known but the overall one.
  [[nodiscard]] std::vector<double> sigma_at_places(const Execution& execution);
  [[nodiscard]] LocalNoise at_points(const Execution& execution);

 private:
  /// Logarithms at one place.
  struct Value {
    double log_sigma = 0;
    double log_spacing = 0;
  };
  void measure(const Execution& execution);
  void find_values(const Execution& execution);
  [[nodiscard]] Value interpolate(const Vec3& at) const;

  NoiseSurvey survey_;
  NoiseEstimate local_;    ///< in the unit of the working set
  NoiseEstimate overall_;  ///< in that of the cloud
  std::vector<Vec3> places_;
  std::unique_ptr<KdTree> tree_;  ///< of the places
  std::vector<Value> values_;
};

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "point_class.hpp"

#include "lane_spectrum.hpp"
#include "require.hpp"

namespace deburr {

void validate(const FeatureOptions& options) {
  require(options.rho >= 0 && options.rho < 1, "features.rho", "in [0, 1)", options.rho);
  require(options.tau > 0 && options.tau < 1, "features.tau", "in (0, 1)", options.tau);
}

DEBURR_MULTIVERSION
void classify_points(const Moments& moments, const FeatureOptions& options, PointClasses& classes) {
  const Lanes count = moments.count + 1;  // the point itself takes part, at offset 0
  LanesSym3 covariance = moments.outer;
  covariance.add_outer(-1 / count, moments.sum);
  covariance.scale(1 / count);
  const LaneBits compared =
      (moments.count != 0.0) & (covariance.xx + covariance.yy + covariance.zz > 0.0);

  const LanesSpectrum s = spectrum(covariance, options.eigen_tolerance);
  const auto& l = s.values;
  const Lanes threshold = options.tau * sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
  const LaneBits flat = (l[2] < threshold) & (l[0] > threshold);
  const LaneBits edge = flat & (l[1] < threshold);
  const LaneBits surface = flat & (l[1] > threshold);
  for (std::size_t at = 0; at < lane_count; ++at) {
    if (compared[at] == 0) {
      classes[at] = {};
    } else if (edge[at] != 0) {
      classes[at] = {Feature::Edge, lane(s.vectors[0], at)};
    } else {
      classes[at] = {surface[at] != 0 ? Feature::Surface : Feature::Corner, {}};
    }
  }
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/noise.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "kd_tree.hpp"
#include "noise_statistics.hpp"
#include "parallel.hpp"
#include "patch_survey.hpp"
#include "working_set.hpp"

namespace deburr {

NoiseEstimate measure_noise(Points points, const Execution& execution) {
  const bool debug = std::getenv("NDEB") != nullptr;
  const double c0 = std::getenv("NC") ? atof(std::getenv("NC")) : 3.3; const double c1=std::getenv("NC1") ? atof(std::getenv("NC1")) : 10; double suff=0,suff0=0;
  PointCloud cloud;
  cloud.points.assign(points.begin(), points.end());
  const WorkingSet set = make_working_set(
      cloud, {.merge_duplicates = true, .local_coordinates = true}, execution);
  if (set.points.size() < 16) return {};
  const KdTree tree(set.points, execution);
  PatchSurvey survey(set.points, tree);
  NoiseEstimate before;
  NoiseEstimate now;
  while (survey.has_size(survey.sizes())) {
    survey.add_size(execution);
    before = now; suff0=suff; suff=c0*(1+c1/(double)survey.count(survey.sizes()-1));
    now = combine_patches(survey.patches(survey.sizes() - 1));
    if (debug) std::printf("k=%zu n=%zu sigma=%.4g spacing=%.4g reach=%.4g r/s=%.3f\n", survey.count(survey.sizes()-1), survey.patches(survey.sizes()-1).size(), set.length(now.sigma), set.length(now.spacing), set.length(now.reach), now.reach/now.sigma);
    if (now.reach >= suff * now.sigma && !debug) break;
  }
  if (survey.sizes() > 1 && now.reach >= suff * now.sigma) {
    const double a = std::log(before.reach / before.sigma/suff0);
    const double b = std::log(now.reach / now.sigma/suff);
    const double t = b>a?std::clamp(-a / (b-a),0.,1.):1;
    now.sigma = 1.02*before.sigma * std::pow(now.sigma / before.sigma, t);
    now.reach = suff * now.sigma;
  }
  return {set.length(now.sigma), set.length(now.spacing), set.length(now.reach)};
}

double estimate_noise(Points points, const Execution& execution) {
  return measure_noise(points, execution).sigma;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "noise_survey.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "noise_sheets.hpp"
#include "noise_tails.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

constexpr std::size_t fewest_points = 16;
/// Larger patches tell more of the noise than smaller ones do, but up to here only, beyond which
/// curvature shows.
constexpr std::size_t most_to_grow = 48;
/// Patches of up to so many points can mistake noise with heavy tails for a surface with points off
/// it.
constexpr std::size_t most_with_tails = 100;
constexpr std::size_t places_for_tails = 512;
constexpr std::size_t places_for_sheets = 128;
constexpr std::size_t points_for_distance = 4096;

WorkingSet distinct_points(Points points, const Execution& execution) {
  PointCloud cloud;
  cloud.points.assign(points.begin(), points.end());
  return make_working_set(cloud, {.merge_duplicates = true, .local_coordinates = true}, execution);
}

}  // namespace

NoiseSurvey::NoiseSurvey(Points points, const Execution& execution)
    : NoiseSurvey(distinct_points(points, sub_execution(execution, "noise", 0, 0.3)), execution) {}

NoiseSurvey::NoiseSurvey(WorkingSet set, const Execution& execution)
    : set_(std::move(set)), tree_(set_.points, execution), patches_(set_.points, tree_) {}

bool NoiseSurvey::has_enough_points() const { return set_.points.size() >= fewest_points; }

void NoiseSurvey::add_size(const Execution& execution) {
  const std::size_t size = patches_.sizes();
  patches_.add_size(without_progress(execution));
  sizes_.push_back(combine(patches_.patches(size), patches_.count(size), flattest_of_all));
}

NoiseEstimate NoiseSurvey::overall(const Execution& execution) {
  if (!has_enough_points()) return {};
  do {
    add_size(execution);
  } while (sizes_.back().resolution() < 1 && patches_.has_size(patches_.sizes()));
  // Where no size is large enough, the one that comes nearest to it.
  SizeEstimate best = *std::ranges::max_element(sizes_, {}, &SizeEstimate::resolution);
  if (sizes_.back().resolution() >= 1) {
    best = sizes_.back();
    const std::size_t resolved = sizes_.size();
    if (resolved > 1) best = between(sizes_[resolved - 2], best);
    const SizeEstimate smallest = sizes_.back();
    while (patches_.count(patches_.sizes()) <= most_to_grow &&
           patches_.has_size(patches_.sizes())) {
      add_size(execution);
      if (!continues(smallest, sizes_.back())) break;
      best.sigma = sizes_.back().sigma;
    }
    best.sigma = whole_sigma(smallest.count, best.sigma, execution);
  }
  CloseSheets close;
  // What rounding leaves of no noise at all has no sheets.
  constexpr double rounding = 1e-9;
  if (best.sigma > rounding * best.reach) {
    close = find_close_sheets(set_.points, tree_, some_places(places_for_sheets), best.count,
                              best.sigma, without_progress(execution));
    if (close.found) best.sigma = close.sigma;
  }
  if (execution.progress) execution.progress({"noise", 1});
  return {best.sigma, best.spacing, best.reach, close.found ? close.gap : 0};
}

double NoiseSurvey::neighbor_distance(std::size_t k, const Execution& execution) const {
  // Not at the places of the patches: they are in the middle of the noise, where points are dense.
  const std::size_t n = set_.points.size();
  const std::size_t step = (n + points_for_distance - 1) / points_for_distance;
  const std::size_t others = std::min(k, n - std::min<std::size_t>(1, n));
  if (others == 0) return 0;
  const std::size_t some = (n + step - 1) / step;
  const double sum = parallel_sum(some, execution, [&](std::size_t i) {
    thread_local std::vector<Found> found;
    tree_.nearest(static_cast<std::uint32_t>(i * step), others,
                  std::numeric_limits<double>::infinity(), found);
    double distances = 0;
    for (const Found& f : found) distances += std::sqrt(f.squared_distance);
    return distances;
  });
  return sum / static_cast<double>(some * others);
}

std::vector<Vec3> NoiseSurvey::some_places(std::size_t number) const {
  const std::vector<Vec3>& sample = patches_.sample();
  const std::size_t step = std::max<std::size_t>(1, sample.size() / number);
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < sample.size(); i += step) places.push_back(sample[i]);
  return places;
}

double NoiseSurvey::whole_sigma(std::size_t count, double sigma, const Execution& execution) const {
  if (count > most_with_tails) return sigma;
  return with_tails(set_.points, tree_, some_places(places_for_tails), count, sigma,
                    without_progress(execution));
}

}  // namespace deburr

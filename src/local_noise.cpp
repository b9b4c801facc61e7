// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "local_noise.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "parallel.hpp"

namespace deburr {
namespace {

/// One of so many places of the survey has a value.
constexpr std::size_t place_step = 2;
/// Places whose patches are taken together, and those over whose values is then averaged.
constexpr std::size_t group_size = 48;
constexpr std::size_t smooth_size = 6;
/// Places that the values at a point are interpolated from.
constexpr std::size_t interpolated = 6;
/// Sizes beyond the one that resolves the overall noise: patches four times as wide.
constexpr std::size_t more_sizes = 8;

/// No noise at all has no logarithm; what is below this, of a cloud of size 1, is rounding.
constexpr double least = 1e-14;

/// What one neighbourhood of places shows.
struct Group {
  double log_sigma = 0;
  double log_spacing = 0;
  bool resolved = false;
  SizeEstimate before{};  ///< at the last size that was too small
};

/// How much of a difference in log sigma to believe, after James and Stein, Estimation with
/// quadratic loss, 1961, eq. (8): what is within its own scatter is taken back to 0.
double believed(double difference, double white) {
  constexpr double scatter = 0.2;
  constexpr double fewest_white = 0.15;
  constexpr double enough_white = 0.4;
  if (!(std::abs(difference) > scatter)) return 0;
  // Where hardly any patch is clear of features, they are what it sees.
  const double evidence =
      std::clamp((white - fewest_white) / (enough_white - fewest_white), 0.0, 1.0);
  const double ratio = scatter / difference;
  return evidence * (1 - ratio * ratio) * difference;
}

/// Every stride-th place.
std::vector<Vec3> thinned(const std::vector<Vec3>& places, std::size_t stride) {
  std::vector<Vec3> some;
  for (std::size_t i = 0; i < places.size(); i += stride) some.push_back(places[i]);
  return some;
}

/// Lets the group at every place look at patches of one size.
void add_size(const PatchSurvey& survey, std::size_t size, const NoiseEstimate& overall,
              std::span<const Vec3> at, std::vector<Group>& groups, const Execution& execution) {
  const std::vector<SurfacePatch>& patches = survey.patches(size);
  const std::vector<Vec3> places = thinned(survey.sample(), survey.stride(size));
  const KdTree tree(places);
  constexpr std::size_t block = 64;
  parallel_blocks<block>(groups.size(), execution, [&](std::size_t begin, std::size_t end) {
    std::vector<Found> found;
    std::vector<SurfacePatch> near;
    for (std::size_t i = begin; i < end; ++i) {
      Group& group = groups[i];
      if (group.resolved) continue;
      tree.nearest_to(at[i], group_size, std::numeric_limits<double>::infinity(), found);
      near.clear();
      for (const Found& f : found) near.push_back(patches[f.index]);
      const SizeEstimate now = combine(near, survey.count(size), flattest_of_few);
      if (!(now.spacing > 0)) continue;
      const SizeEstimate best = size > 0 ? between(group.before, now) : now;
      group.log_spacing = std::log(now.spacing);
      group.before = now;
      if (now.resolution() < 1) continue;
      group.resolved = true;
      group.log_sigma = std::log(std::max(best.sigma, least));
      if (overall.sigma > least) {
        const double log_overall = std::log(overall.sigma);
        group.log_sigma = log_overall + believed(group.log_sigma - log_overall, now.white);
      }
    }
  });
}

/// Noise and spacing at places, as logarithms.
std::vector<Group> group_noise(PatchSurvey& patches, std::span<const Vec3> at,
                               const NoiseEstimate& overall, const Execution& execution) {
  const Group unknown{.log_sigma = std::log(std::max(overall.sigma, least)),
                      .log_spacing = std::log(std::max(overall.spacing, least))};
  std::vector<Group> groups(at.size(), unknown);
  const std::size_t end = patches.sizes() + more_sizes;
  for (std::size_t size = 0; size < end && patches.has_size(size); ++size) {
    if (std::ranges::all_of(groups, &Group::resolved)) break;
    if (size == patches.sizes()) patches.add_size(execution);
    add_size(patches, size, overall, at, groups, execution);
  }
  return groups;
}

}  // namespace

LocalNoiseField::LocalNoiseField(Points points, const Execution& execution)
    : survey_(points, sub_execution(execution, "noise", 0, 0.5)) {
  measure(execution);
}

LocalNoiseField::LocalNoiseField(WorkingSet set, const Execution& execution)
    : survey_(std::move(set), execution) {
  measure(execution);
}

void LocalNoiseField::measure(const Execution& execution) {
  local_ = survey_.overall(sub_execution(execution, "noise", 0.5, 1));
  const WorkingSet& set = survey_.set();
  overall_ = {set.length(local_.sigma), set.length(local_.spacing), set.length(local_.reach),
              set.length(local_.gap)};
}

double LocalNoiseField::neighbor_distance(std::size_t k, const Execution& execution) const {
  return survey_.set().length(survey_.neighbor_distance(k, execution));
}

/// Means over the nearest places of what the groups there show.
void LocalNoiseField::find_values(const Execution& execution) {
  // Of sheets that lie close over each other, patches of single places show the gap.
  if (tree_ || !survey_.has_enough_points() || !(local_.spacing > 0) || local_.gap > 0) return;
  places_ = thinned(survey_.patches().sample(), place_step);
  tree_ = std::make_unique<KdTree>(places_, execution);
  const std::vector<Group> groups = group_noise(survey_.patches(), places_, local_, execution);
  values_.resize(groups.size());
  parallel_for(groups.size(), execution, [&](std::size_t i) {
    thread_local std::vector<Found> found;
    tree_->nearest_to(places_[i], smooth_size, std::numeric_limits<double>::infinity(), found);
    const double share = 1 / static_cast<double>(found.size());
    for (const Found& f : found) {
      values_[i].log_sigma += share * groups[f.index].log_sigma;
      values_[i].log_spacing += share * groups[f.index].log_spacing;
    }
  });
}

/// The value at a place from those at the nearest ones, by inverse squared distance, softened by
/// the distance of the farthest so that it is smooth at the places themselves.
LocalNoiseField::Value LocalNoiseField::interpolate(const Vec3& at) const {
  thread_local std::vector<Found> found;
  tree_->nearest_to(at, interpolated, std::numeric_limits<double>::infinity(), found);
  const double soft = 0.25 * found.back().squared_distance;
  if (!(soft > 0)) return values_[found.front().index];
  Value value;
  double sum = 0;
  for (const Found& f : found) {
    const double weight = 1 / (f.squared_distance + soft);
    value.log_sigma += weight * values_[f.index].log_sigma;
    value.log_spacing += weight * values_[f.index].log_spacing;
    sum += weight;
  }
  return {value.log_sigma / sum, value.log_spacing / sum};
}

std::vector<double> LocalNoiseField::sigma_at_places(const Execution& execution) {
  find_values(without_progress(execution));
  std::vector<double> sigma;
  sigma.reserve(values_.size());
  for (const Value& v : values_) sigma.push_back(survey_.set().length(std::exp(v.log_sigma)));
  return sigma;
}

LocalNoise LocalNoiseField::at_points(const Execution& execution) {
  const WorkingSet& set = survey_.set();
  LocalNoise noise{overall_, {}, {}};
  noise.sigma.assign(set.slot.size(), overall_.sigma);
  noise.spacing.assign(set.slot.size(), overall_.spacing);
  find_values(without_progress(execution));
  if (values_.empty()) return noise;
  std::vector<Value> at(set.points.size());
  parallel_for(at.size(), sub_execution(execution, "noise", 0, 1),
               [&](std::size_t i) { at[i] = interpolate(set.points[i]); });
  for (std::size_t i = 0; i < set.slot.size(); ++i) {
    if (set.slot[i] == WorkingSet::none) continue;
    noise.sigma[i] = set.length(std::exp(at[set.slot[i]].log_sigma));
    noise.spacing[i] = set.length(std::exp(at[set.slot[i]].log_spacing));
  }
  return noise;
}

LocalNoise estimate_local_noise(Points points, const Execution& execution) {
  LocalNoiseField field(points, sub_execution(execution, "noise", 0, 0.6));
  return field.at_points(sub_execution(execution, "noise", 0.6, 1));
}

}  // namespace deburr

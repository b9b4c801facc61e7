// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "deburr/noise.hpp"
#include "noise_survey.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

/// Places whose patches are taken together, and over which what they show is then averaged.
constexpr std::size_t group_size = 48;
constexpr std::size_t smooth_size = 12;
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

/// Lets every group look at patches of one size.
void add_size(const PatchSurvey& survey, std::size_t size, const NoiseEstimate& overall,
              std::vector<Group>& groups, const Execution& execution) {
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
      tree.nearest_to(survey.sample()[i], group_size, std::numeric_limits<double>::infinity(),
                      found);
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

/// Noise and spacing at the places of a sample, as logarithms.
std::vector<Group> group_noise(NoiseSurvey& survey, const NoiseEstimate& overall,
                               const Execution& execution) {
  PatchSurvey& patches = survey.patches();
  const Group unknown{.log_sigma = std::log(std::max(overall.sigma, least)),
                      .log_spacing = std::log(std::max(overall.spacing, least))};
  std::vector<Group> groups(patches.sample().size(), unknown);
  const std::size_t end = patches.sizes() + more_sizes;
  for (std::size_t size = 0; size < end && patches.has_size(size); ++size) {
    if (std::ranges::all_of(groups, &Group::resolved)) break;
    if (size == patches.sizes()) patches.add_size(execution);
    add_size(patches, size, overall, groups, execution);
  }
  return groups;
}

/// Means over the nearest places.
std::vector<Group> smoothed(const std::vector<Group>& groups, const std::vector<Vec3>& places,
                            const KdTree& tree, const Execution& execution) {
  std::vector<Group> smooth(groups.size());
  parallel_for(groups.size(), execution, [&](std::size_t i) {
    std::vector<Found> found;
    tree.nearest_to(places[i], smooth_size, std::numeric_limits<double>::infinity(), found);
    const double share = 1 / static_cast<double>(found.size());
    for (const Found& f : found) {
      smooth[i].log_sigma += share * groups[f.index].log_sigma;
      smooth[i].log_spacing += share * groups[f.index].log_spacing;
    }
  });
  return smooth;
}

/// The value at a place from those at the nearest ones, by inverse squared distance, softened by
/// the distance of the farthest so that it is smooth at the places themselves.
Group interpolate(const std::vector<Group>& groups, const std::vector<Found>& found) {
  const double soft = 0.25 * found.back().squared_distance;
  if (!(soft > 0)) return groups[found.front().index];
  Group at;
  double sum = 0;
  for (const Found& f : found) {
    const double weight = 1 / (f.squared_distance + soft);
    at.log_sigma += weight * groups[f.index].log_sigma;
    at.log_spacing += weight * groups[f.index].log_spacing;
    sum += weight;
  }
  at.log_sigma /= sum;
  at.log_spacing /= sum;
  return at;
}

}  // namespace

LocalNoise estimate_local_noise(Points points, const Execution& execution) {
  NoiseSurvey survey(points, sub_execution(execution, "noise", 0, 0.3));
  const NoiseEstimate overall = survey.overall(sub_execution(execution, "noise", 0.3, 0.6));
  const WorkingSet& set = survey.set();
  LocalNoise noise;
  noise.overall = {set.length(overall.sigma), set.length(overall.spacing),
                   set.length(overall.reach), set.length(overall.gap)};
  noise.sigma.assign(points.size(), noise.overall.sigma);
  noise.spacing.assign(points.size(), noise.overall.spacing);
  if (!survey.has_enough_points() || !(overall.spacing > 0)) return noise;
  // Of sheets that lie close over each other, patches of single places show the gap.
  if (overall.gap > 0) return noise;

  const Execution quiet{.threads = execution.threads, .cancelled = execution.cancelled};
  const std::vector<Vec3>& places = survey.patches().sample();
  const KdTree tree(places, quiet);
  const std::vector<Group> groups =
      smoothed(group_noise(survey, overall, quiet), places, tree, quiet);
  std::vector<Group> at(set.points.size());
  parallel_for(at.size(), sub_execution(execution, "noise", 0.6, 1), [&](std::size_t i) {
    thread_local std::vector<Found> found;
    tree.nearest_to(set.points[i], interpolated, std::numeric_limits<double>::infinity(), found);
    at[i] = interpolate(groups, found);
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (set.slot[i] == WorkingSet::none) continue;
    noise.sigma[i] = set.length(std::exp(at[set.slot[i]].log_sigma));
    noise.spacing[i] = set.length(std::exp(at[set.slot[i]].log_spacing));
  }
  return noise;
}

}  // namespace deburr

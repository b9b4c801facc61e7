// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/denoise.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "deburr/error.hpp"
#include "deburr/noise.hpp"
#include "deburr/orientation.hpp"
#include "parallel.hpp"
#include "require.hpp"
#include "schedule.hpp"
#include "stage_clock.hpp"
#include "unit.hpp"
#include "working_set.hpp"

namespace deburr {
namespace {

/// Neighbours in the mean distance that lengths of the default schedule are measured in.
constexpr std::size_t spacing_neighbors = 12;

/// Share of the progress that is told before the rounds begin.
constexpr double prepared = 0.2;

/// The points on their way, in the coordinates of the working set.
struct State {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  FeatureField features;
};

RoundReport measure(Points before, Points after, const WorkingSet& set) {
  double squares = 0;
  double largest = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double squared = squared_norm(after[i] - before[i]);
    squares += squared;
    largest = std::max(largest, squared);
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, before.size()));
  return {set.length(std::sqrt(squares / count)), set.length(std::sqrt(largest))};
}

std::vector<Vec3> first_normals(const WorkingSet& set, const DenoiseOptions& options, bool keep,
                                const Execution& execution) {
  const bool published = options.method == Method::Yadav2018;
  if (keep && published) return set.normals;
  const std::size_t k = published ? options.yadav2018.k : options.automatic.normal_neighbors;
  const Neighborhoods nearest =
      find_neighbors(set.points, {.max_count = k}, sub_execution(execution, "normals", 0, 0.5));
  std::vector<Vec3> unoriented = set.normals;
  if (!keep || std::ranges::any_of(unoriented, is_zero)) {
    const std::vector<Vec3> estimated =
        estimate_normals(set.points, nearest, sub_execution(execution, "normals", 0.5, 0.6));
    unoriented.resize(estimated.size());
    for (std::size_t i = 0; i < estimated.size(); ++i) {
      if (!keep || is_zero(unoriented[i])) unoriented[i] = estimated[i];
    }
  }
  return orient_normals(set.points, unoriented, nearest, execution);
}

/// The rounds: filter the normals, classify the points, move them.
void run(const Schedule& schedule, const WorkingSet& set, State& state, Report& report,
         StageClock& clock, const Execution& execution) {
  Neighborhoods neighborhoods;
  for (int round = 0; round < schedule.rounds; ++round) {
    const Execution part =
        sub_execution(execution, "rounds", prepared + (1 - prepared) * round / schedule.rounds,
                      prepared + (1 - prepared) * (round + 1) / schedule.rounds);
    const Execution quiet{.threads = part.threads, .cancelled = part.cancelled};
    if (round == 0 || schedule.rebuild) {
      neighborhoods = clock.time("neighbourhoods", [&] {
        return find_neighbors(state.points, schedule.neighbors, quiet);
      });
    }
    if (schedule.refit) {
      state.normals = clock.time("normal refit", [&] {
        return refit_normals(state.points, state.normals, neighborhoods, *schedule.refit, quiet);
      });
    }
    state.normals = clock.time("normal filter", [&] {
      return filter_normals(state.normals, neighborhoods, schedule.normal_filter,
                            round == 0 ? schedule.voteless_at_first : Voteless::Keep, quiet);
    });
    std::vector<Vec3> moved = state.points;
    state.features = clock.time("features and positions", [&] {
      return schedule.in_place ? sweep_in_place(set.points, moved, state.normals, neighborhoods,
                                                schedule.features, schedule.update, set.sweep, part)
                               : sweep_at_once(set.points, moved, state.normals, neighborhoods,
                                               schedule.features, schedule.update, part);
    });
    report.rounds.push_back(measure(state.points, moved, set));
    state.points = std::move(moved);
  }
}

/// Puts what was found into the order of the cloud.
void fill_result(const WorkingSet& set, const State& state, DenoiseResult& result) {
  PointCloud& cloud = result.cloud;
  cloud.normals.resize(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint32_t slot = set.slot[i];
    if (slot == WorkingSet::none) continue;
    const Vec3 before = cloud.points[i];
    cloud.points[i] = set.moved(before, set.points[slot], state.points[slot]);
    cloud.normals[i] = state.normals[slot];
    result.labels[i] = state.features.label[slot];
    if (cloud.points[i] == before) continue;
    // In local coordinates, where no square overflows.
    result.displacement[i] = set.length(norm(state.points[slot] - set.points[slot]));
  }
}

}  // namespace

DenoiseResult denoise(const PointCloud& cloud, const DenoiseOptions& options,
                      const Execution& execution) {
  validate(options);
  (void)thread_count(execution);
  const bool has_normals = !cloud.normals.empty();
  if (has_normals) require_size("normals", cloud.normals.size(), cloud.size());
  if (options.normals == NormalSource::Keep && !has_normals && cloud.size() > 0) {
    throw DataError("normals are to be kept, but the points have none");
  }
  const bool published = options.method == Method::Yadav2018;
  const std::size_t spacing_k = published ? options.yadav2018.k : spacing_neighbors;

  DenoiseResult result;
  result.cloud = cloud;
  result.labels.assign(cloud.size(), Feature::Isolated);
  result.displacement.assign(cloud.size(), 0.0);
  Report& report = result.report;
  report.points = cloud.size();
  StageClock clock(execution);

  const WorkingSet set = clock.time("order", [&] {
    // The published method keeps duplicates, and the unit of the input matters to it.
    return make_working_set(cloud,
                            {.merge_duplicates = !published, .local_coordinates = !published},
                            sub_execution(execution, "order", 0, 0.02));
  });
  report.non_finite = set.non_finite;
  report.duplicates = set.duplicates;
  State state{set.points, set.normals, {}};
  state.normals.resize(set.points.size());
  state.features = {std::vector<Feature>(set.points.size(), Feature::Isolated),
                    std::vector<Vec3>(set.points.size())};

  const auto [spacing, noise] = clock.time("spacing and noise", [&] {
    const auto part = [&](double from, double to) {
      return sub_execution(execution, "spacing and noise", from, to);
    };
    const Neighborhoods nearest =
        find_neighbors(set.points, {.max_count = spacing_k}, part(0.02, 0.05));
    const double mean = mean_neighbor_distance(set.points, nearest, part(0.05, 0.06));
    return std::pair(mean, estimate_noise(set.points, part(0.06, 0.1)));
  });
  if (!std::isfinite(spacing)) {
    throw DataError("the distances between the points are larger than a double can hold");
  }
  report.spacing = set.length(spacing);
  report.noise = set.length(noise);

  constexpr std::size_t fewest_points = 4;
  if (set.points.size() - (published ? set.duplicates : 0) >= fewest_points && spacing > 0) {
    report.kept_normals = has_normals && options.normals != NormalSource::Estimate;
    state.normals = clock.time("first normals", [&] {
      return first_normals(set, options, report.kept_normals,
                           sub_execution(execution, "normals", 0.1, prepared));
    });
    const Schedule schedule = published ? make_schedule(options.yadav2018, spacing)
                                        : make_schedule(options.automatic, spacing, noise);
    report.max_move = set.length(schedule.update.max_move);
    run(schedule, set, state, report, clock, execution);
  }
  fill_result(set, state, result);
  for (const Feature label : result.labels) ++report.labels[static_cast<std::size_t>(label)];
  report.stages = std::move(clock).times();
  return result;
}

}  // namespace deburr

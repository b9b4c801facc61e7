// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/denoise.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "automatic_parts.hpp"
#include "columns.hpp"
#include "deburr/error.hpp"
#include "deburr/noise.hpp"
#include "keep_points.hpp"
#include "parallel.hpp"
#include "published.hpp"
#include "require.hpp"
#include "run_automatic.hpp"

namespace deburr {
namespace {

/// What is common to both methods: finds the spacing. Returns the `k` nearest of each point.
Neighborhoods measure_spacing(Points points, std::size_t k, const WorkingSet& set, Report& report,
                              const Execution& execution) {
  Neighborhoods nearest =
      find_neighbors(points, {.max_count = k}, sub_execution(execution, "spacing", 0, 0.8));
  const double spacing =
      mean_neighbor_distance(points, nearest, sub_execution(execution, "spacing", 0.8, 1));
  if (!std::isfinite(spacing)) {
    throw DataError("the distances between the points are larger than a double can hold");
  }
  report.spacing = set.length(spacing);
  return nearest;
}

void run_yadav2018(const Yadav2018Options& options, const WorkingSet& set, bool keep_normals,
                   State& state, Report& report, StageClock& clock, const Execution& execution) {
  Neighborhoods nearest = clock.time("spacing and noise", [&] {
    Neighborhoods found =
        measure_spacing(set.points, options.k, set, report,
                        sub_execution(execution, "spacing and noise", 0.02, 0.06));
    report.noise =
        set.length(estimate_noise(set.points, sub_execution(execution, "noise", 0.06, 0.1)));
    return found;
  });
  const double spacing = std::scalbn(report.spacing, -set.exponent);
  constexpr std::size_t fewest_points = 4;
  if (set.points.size() - set.duplicates < fewest_points || !(spacing > 0)) return;
  report.kept_normals = keep_normals;
  const Schedule schedule = make_schedule(options, spacing);
  report.max_move = set.length(schedule.update.max_move);
  run_published(std::move(nearest), schedule, set, keep_normals, state, report, clock,
                sub_execution(execution, "rounds", 0.1, 1));
}

/// Puts what was found into the order of the cloud.
void fill_result(const WorkingSet& set, const State& state, std::span<const std::uint8_t> outliers,
                 DenoiseResult& result, const Execution& execution) {
  PointCloud& cloud = result.cloud;
  resize_column(cloud.normals, cloud.size(), execution);
  result.labels.assign(cloud.size(), Feature::Isolated);
  resize_column(result.displacement, cloud.size(), execution);
  result.outliers.assign(cloud.size(), 0);
  parallel_for(cloud.size(), without_progress(execution), [&](std::size_t i) {
    const std::uint32_t slot = set.slot[i];
    if (slot == WorkingSet::none) return;
    const Vec3 before = cloud.points[i];
    cloud.points[i] = set.moved(before, set.points[slot], state.points[slot]);
    cloud.normals[i] = state.normals[slot];
    result.labels[i] = state.labels[slot];
    result.outliers[i] = outliers[slot];
    if (cloud.points[i] == before) return;
    // In local coordinates, where no square overflows.
    const double moved = set.length(norm(state.points[slot] - set.points[slot]));
    // A move that was cut at the bound is as long as it but for rounding.
    result.displacement[i] = std::min(moved, result.report.max_move);
  });
}

}  // namespace

DenoiseResult denoise(PointCloud cloud, const DenoiseOptions& options, const Execution& execution) {
  return denoise_with({}, std::move(cloud), options, execution);
}

DenoiseResult denoise_with(const AutomaticParts& parts, PointCloud cloud,
                           const DenoiseOptions& options, const Execution& execution) {
  validate(options);
  (void)thread_count(execution);
  const bool has_normals = !cloud.normals.empty();
  if (has_normals) require_size("normals", cloud.normals.size(), cloud.size());
  if (options.normals == NormalSource::Keep && !has_normals && cloud.size() > 0) {
    throw DataError("normals are to be kept, but the points have none");
  }
  const bool published = options.method == Method::Yadav2018;
  const bool keep_normals = has_normals && options.normals != NormalSource::Estimate;

  DenoiseResult result;
  result.cloud = std::move(cloud);
  Report& report = result.report;
  report.points = result.cloud.size();
  StageClock clock(execution);

  WorkingSet set = clock.time("order", [&] {
    // The published method keeps duplicates, and the unit of the input matters to it.
    const WorkingSetOptions how{
        .merge_duplicates = !published, .local_coordinates = !published, .sweep = published};
    return make_working_set(result.cloud, how, sub_execution(execution, "order", 0, 0.02));
  });
  if (!keep_normals) release(set.normals);
  report.non_finite = set.non_finite;
  report.duplicates = set.duplicates;
  State state;
  std::vector<std::uint8_t> outliers(set.points.size(), 0);
  if (published) {
    state = State::of(set);
    run_yadav2018(options.yadav2018, set, keep_normals, state, report, clock, execution);
  } else {
    state = run_automatic(options.automatic, parts, set, outliers, report, clock, execution);
  }
  fill_result(set, state, outliers, result, execution);
  for (const Feature label : result.labels) ++report.labels[static_cast<std::size_t>(label)];
  report.outliers = static_cast<std::size_t>(std::ranges::count(result.outliers, 1));
  if (options.automatic.outliers == OutlierAction::Remove && report.outliers > 0) {
    remove_outliers(result);
  }
  report.kept = result.cloud.size();
  // Whoever asks at the very last to stop gets no result either.
  check_cancelled(execution);
  report.stages = std::move(clock).times();
  return result;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "run_automatic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "automatic.hpp"
#include "columns.hpp"
#include "local_noise.hpp"
#include "noise_levels.hpp"
#include "outliers_of_distinct.hpp"
#include "parallel.hpp"
#include "take_out.hpp"

namespace deburr {
namespace {

/// Neighbours in the mean distance that the default method reports as the spacing.
constexpr std::size_t spacing_neighbors = 12;

/// Movement in standard deviations of the noise: more is hardly ever noise.
constexpr double most_deviations = 4;

/// Noise that the default method works with at least, in spacings: rounding must not pass for a
/// surface.
constexpr double least_noise = 0.01;

/// How the noise between sheets that lie close over each other is used: noise takes points to the
/// wrong one of them, and fits that expect all of it draw them together. So less is expected where
/// they are fewer standard deviations apart, and no point moves by more than a part of the gap.
struct Caution {
  double noise = 1;  ///< share of the noise to expect
  double max_move = std::numeric_limits<double>::infinity();

  explicit Caution(const NoiseEstimate& estimate) {
    constexpr double clear = 7;  // standard deviations from which on hardly a point is in between
    constexpr double least = 0.6;
    constexpr double way = 0.3;
    if (!(estimate.gap > 0)) return;
    noise = std::clamp(estimate.gap / (clear * estimate.sigma), least, 1.0);
    max_move = way * estimate.gap;
  }
};

/// The levels of noise, times the strength, of a cloud in which it differs from place to place.
NoiseLevels levels_of(LocalNoiseField& field, double strength, const Execution& execution) {
  const NoiseEstimate& estimate = field.overall();
  const double least = least_noise * estimate.spacing;
  // Where much of the cloud has none, what looks like noise elsewhere is detail.
  if (!(estimate.sigma > least)) return {};
  const auto levels = [&](std::vector<double> sigma) {
    for (double& s : sigma) s *= strength;
    return find_noise_levels(sigma, least);
  };
  // Single places tell whether it is worth asking for every point.
  if (levels(field.sigma_at_places(without_progress(execution))).sigma.empty()) return {};
  return levels(field.at_points(execution).sigma);
}

/// The default method on points without outliers; no result where they have no spacing.
std::optional<AutomaticResult> run_on_surface(const AutoOptions& options,
                                              const AutomaticParts& parts, const WorkingSet& set,
                                              Report& report, StageClock& clock,
                                              const Execution& execution) {
  constexpr std::array by_strength{0.5, 1 / std::numbers::sqrt2, 1.0, std::numbers::sqrt2, 2.0};
  const double strength = by_strength.at(static_cast<std::size_t>(options.strength - 1));
  NoiseEstimate estimate;
  NoiseLevels levels;
  clock.time("spacing and noise", [&] {
    LocalNoiseField field(set_of_distinct(copy_column(Points(set.points), execution)),
                          sub_execution(execution, "noise", 0.15, 0.22));
    const Execution rest = sub_execution(execution, "noise", 0.22, 0.25);
    report.spacing = set.length(field.neighbor_distance(spacing_neighbors, without_progress(rest)));
    estimate = field.overall();
    if (!(options.noise > 0) && parts.noise_levels) levels = levels_of(field, strength, rest);
    return 0;
  });
  // Given lengths may be of any size; the points lie within a box of 4.
  const auto local = [&](double length) {
    return std::min(std::scalbn(length, -set.exponent), 4.0);
  };
  const double spacing =
      estimate.spacing > 0 || options.noise == 0 ? estimate.spacing : local(report.spacing);
  if (!(spacing > 0)) return std::nullopt;
  const Caution caution(options.noise > 0 ? NoiseEstimate{} : estimate);
  const double found = strength * (options.noise > 0 ? local(options.noise) : estimate.sigma);
  const double noise = caution.noise * found;
  const double given_move = local(options.max_move);
  double max_move =
      given_move > 0 ? given_move : std::min(most_deviations * noise, caution.max_move);
  const double least = least_noise * spacing;
  const AutomaticInput input{set.points, set.normals, std::max(noise, least),
                             spacing,    max_move,    parts};
  const Execution part = sub_execution(execution, "denoise", 0.25, 1);
  AutomaticResult result;
  if (levels.sigma.empty()) {
    result = denoise_automatically(input, clock, part);
  } else {
    result = denoise_at_levels(input, levels, given_move, most_deviations, clock, part);
    if (!(given_move > 0)) max_move = most_deviations * levels.sigma.back();
  }
  report.noise = set.length(found);
  report.max_move = set.length(max_move);
  report.kept_normals = result.kept_normals;
  return result;
}

}  // namespace

State run_automatic(const AutoOptions& options, const AutomaticParts& parts, WorkingSet& set,
                    std::vector<std::uint8_t>& outliers, Report& report, StageClock& clock,
                    const Execution& execution) {
  if (options.outliers != OutlierAction::Keep) {
    outliers = clock.time("outliers", [&] {
      return find_outliers_of_distinct(set.points, {},
                                       sub_execution(execution, "outliers", 0.02, 0.15));
    });
  }
  std::vector<Vec3> left_out = take_out(set.points, outliers);
  if (!set.normals.empty()) (void)take_out(set.normals, outliers);
  std::optional<AutomaticResult> result =
      run_on_surface(options, parts, set, report, clock, execution);
  put_back(set.points, left_out, outliers, execution);
  if (!result) return State::of(set);
  const std::size_t some = left_out.size();
  put_back(result->points, std::move(left_out), outliers, execution);
  put_back(result->normals, std::vector<Vec3>(some), outliers, execution);
  put_back(result->labels, std::vector<Feature>(some, Feature::Isolated), outliers, execution);
  return {std::move(result->points), std::move(result->normals), std::move(result->labels)};
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "pilot.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "columns.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/normal_filter.hpp"
#include "deburr/normals.hpp"
#include "deburr/orientation.hpp"
#include "deburr/position_update.hpp"
#include "parallel.hpp"
#include "surface_nodes.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

constexpr double normal_scale = 0.35;

/// Rounds, and the share of each move. Over cells rounds cost little, and the noise, many spacings,
/// needs more of them; with less noise, more rounds round edges off.
struct Rounds {
  int count;
  double step;
};
constexpr Rounds of_cells{4, 0.5};
constexpr Rounds of_points{2, 0.8};

/// Scale of the weights: so many spacings and so many standard deviations of the noise.
constexpr double scale_spacings = 0.45;
constexpr double scale_noises = 2.2;
constexpr double radius_scales = 2.4;  ///< of the neighbourhoods, in scales
constexpr std::size_t most_neighbors = 500;

/// First normals: the neighbourhood must be wider than the noise, whatever that takes.
constexpr double fewest_neighbors = 18;
constexpr double neighbors_per_noise = 40;  ///< for each square of noise over spacing
constexpr std::size_t graph_neighbors = 24;

/// Side of a cell where points are merged: so many spacings and so many standard deviations of the
/// noise. The weights are wider.
constexpr double cell_spacings = 1.4;
constexpr double cell_noises = 1.2;

/// First normals, and the neighbourhoods of all rounds.
struct Start {
  std::vector<Vec3> normals;
  Neighborhoods neighborhoods;
};

Start find_start(Points points, Normals given, double ratio, double radius,
                 const Execution& execution) {
  const auto count = static_cast<std::size_t>(
      std::clamp(neighbors_per_noise * ratio * ratio, fewest_neighbors, double{most_neighbors}));
  Neighborhoods around =
      find_neighbors(points, {.max_count = count}, sub_execution(execution, "pilot", 0, 0.3));
  std::vector<Vec3> normals =
      estimate_normals(points, around, sub_execution(execution, "pilot", 0.3, 0.4));
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (!is_zero(given[i])) normals[i] = given[i];
  }
  Start start;
  const Execution quiet = without_progress(execution);
  if (count > graph_neighbors) {
    around = find_neighbors(points, {.max_count = graph_neighbors}, quiet);
  }
  start.normals = orient_normals(points, normals, around, quiet);
  around = {};
  start.neighborhoods =
      find_neighbors(points, {.max_count = most_neighbors, .radius = radius}, quiet);
  return start;
}

}  // namespace

Pilot find_pilot(const AutomaticInput& input, const Execution& execution) {
  const bool merge = is_dense(input);
  SurfaceNodes nodes;
  if (merge) {
    const double cell = cell_spacings * input.spacing + cell_noises * input.noise;
    nodes = merge_into_cells(input.points, input.points, {}, {}, {}, cell, 1, execution);
    for (auto* unread : {&nodes.weights, &nodes.trust}) release(*unread);
    release(nodes.normals);
  }
  const Points measured = merge ? nodes.measured : input.points;
  const double spacing = input.spacing * std::sqrt(static_cast<double>(input.points.size()) /
                                                   static_cast<double>(measured.size()));
  // Given normals are of single points, and their signs may be at odds.
  const double scale = scale_spacings * spacing + scale_noises * input.noise;
  auto [normals, neighborhoods] =
      find_start(measured, merge ? Normals{} : input.normals, input.noise / spacing,
                 radius_scales * scale, sub_execution(execution, "pilot", 0, 0.6));
  std::vector<Vec3> places(measured.begin(), measured.end());
  const auto [rounds, step] = merge ? of_cells : of_points;
  FeatureField field;
  for (int round = 0; round < rounds; ++round) {
    const Execution part = sub_execution(execution, "pilot", 0.6 + 0.4 * round / rounds,
                                         0.6 + 0.4 * (round + 1) / rounds);
    const Execution quiet = without_progress(part);
    normals = refit_normals(places, normals, neighborhoods,
                            {.position_scale = scale, .normal_scale = normal_scale}, quiet);
    normals = filter_normals(normals, neighborhoods, {}, Voteless::Keep, quiet);
    field = sweep_at_once(measured, places, normals, neighborhoods, {},
                          {.position_scale = scale,
                           .normal_scale = normal_scale,
                           .step = step,
                           .max_move = input.max_move},
                          part);
  }
  neighborhoods = {};

  Pilot pilot;
  pilot.merged = merge;
  pilot.lone.resize(input.points.size());
  if (!merge) {
    for (std::size_t i = 0; i < measured.size(); ++i) {
      pilot.lone[i] = field.label[i] == Feature::Isolated ? 1 : 0;
    }
    pilot.places = std::move(places);
    pilot.normals = std::move(normals);
    return pilot;
  }
  resize_column(pilot.places, input.points.size(), execution);
  resize_column(pilot.normals, input.points.size(), execution);
  parallel_for(input.points.size(), without_progress(execution), [&](std::size_t i) {
    const std::uint32_t node = nodes.of[i];
    const Vec3 within = input.points[i] - nodes.measured[node];
    const Vec3& n = normals[node];
    pilot.places[i] = places[node] + within - dot(within, n) * n;
    pilot.normals[i] = n;
    pilot.lone[i] = field.label[node] == Feature::Isolated ? 1 : 0;
  });
  return pilot;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "automatic.hpp"

#include <algorithm>
#include <cmath>

#include "kd_tree.hpp"
#include "landing.hpp"
#include "node_fits.hpp"
#include "node_levels.hpp"
#include "parallel.hpp"
#include "pilot.hpp"
#include "surface_nodes.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Side of a node's cell where points are merged, in standard deviations of the noise.
constexpr double node_cell = 1.0;

NodeLevels make_levels(const AutomaticInput& input, Points measured, Points places, Normals normals,
                       std::span<const double> trust, const Execution& execution) {
  SurfaceNodes nodes = is_dense(input) ? merge_into_cells(measured, places, normals, {}, trust,
                                                          node_cell * input.noise, 1, execution)
                                       : nodes_of_points(measured, places, normals, trust);
  const double per_node = static_cast<double>(measured.size()) / static_cast<double>(nodes.size());
  return {std::move(nodes), input.spacing * std::sqrt(per_node), input.noise, execution};
}

/// Of each node, whether any of its points is one of some.
std::vector<std::uint8_t> nodes_of_some(const SurfaceNodes& nodes,
                                        std::span<const std::uint8_t> some) {
  std::vector<std::uint8_t> of_nodes(nodes.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    if (some[i] != 0) of_nodes[nodes.of[i]] = 1;
  }
  return of_nodes;
}

/// What the pilot found to be of no surface stays where it was measured.
void keep_lone(const AutomaticInput& input, const std::vector<bool>& lone,
               AutomaticResult& result) {
  for (std::size_t i = 0; i < lone.size(); ++i) {
    if (!lone[i]) continue;
    result.points[i] = input.points[i];
    result.labels[i] = Feature::Isolated;
  }
}

}  // namespace

AutomaticResult denoise_automatically(const AutomaticInput& input, StageClock& clock,
                                      const Execution& execution) {
  const auto part = [&](std::string_view stage, double from, double to) {
    return sub_execution(execution, stage, from, to);
  };
  AutomaticResult result;
  std::vector<bool> lone;
  result.labels.assign(input.points.size(), Feature::Surface);
  clock.time("pilot", [&] {
    Pilot pilot = find_pilot(input, part("pilot", 0, 0.4));
    lone = std::move(pilot.lone);
    result.kept_normals = !pilot.merged && !std::ranges::all_of(input.normals, is_zero);
    result.points = std::move(pilot.places);
    result.normals = std::move(pilot.normals);
    return 0;
  });
  if (!input.parts.fits) {
    keep_lone(input, lone, result);
    return result;
  }

  // A first pass tells how fits of every size fare, the second takes the best of them.
  const NodeLevels first =
      make_levels(input, input.points, result.points, result.normals, {}, part("fits", 0.4, 0.42));
  const FitSteps steps = fit_steps(input.noise / first.spacing(), input.parts);
  const Survey survey = clock.time("fits", [&] {
    return survey_nodes(first, input.noise, steps.survey, input.parts, part("fits", 0.42, 0.6));
  });
  const Shares shares = clock.time("landing", [&] {
    return land(input, first, survey.sheets, {steps.survey, {}}, result,
                part("landing", 0.6, 0.65));
  });
  if (!input.parts.second_pass) {
    keep_lone(input, lone, result);
    return result;
  }

  const NodeLevels second = make_levels(input, shares.measured, shares.places, shares.normals,
                                        shares.trust, part("fits", 0.65, 0.67));
  const std::vector<std::uint8_t> by_edge = nodes_of_some(second.nodes(0), shares.by_edge);
  const NodeSheets sheets = clock.time("fits", [&] {
    return fit_nodes(first, survey, second, by_edge, input.noise, steps, input.parts,
                     part("fits", 0.67, 0.9));
  });
  clock.time("landing", [&] {
    return land(input, second, sheets, {steps.even, by_edge}, result, part("landing", 0.9, 1));
  });
  keep_lone(input, lone, result);
  return result;
}

}  // namespace deburr

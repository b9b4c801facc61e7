// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "automatic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "landing.hpp"
#include "lent_result.hpp"
#include "node_fits.hpp"
#include "node_levels.hpp"
#include "parallel.hpp"
#include "pilot.hpp"
#include "surface_nodes.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Side of a node's cell where points are merged: so many spacings less so many standard deviations
/// of the noise, and at least one of these. Wide cells cost less, but the more noise there is, the
/// more points of other faces get into those by edges.
constexpr double cell_spacings = 2.6;
constexpr double cell_noises = 0.9;

/// Points, or parts of points, merged into the nodes of a dense cloud.
SurfaceNodes merge(const AutomaticInput& input, Points measured, Points places, Normals normals,
                   std::span<const double> trust, const Execution& execution) {
  const double cell =
      std::max(input.noise, cell_spacings * input.spacing - cell_noises * input.noise);
  return merge_into_cells(measured, places, normals, {}, trust, cell, 1, execution);
}

/// What is to be said of nodes when their levels are gone.
FittedNodes describe(const AutomaticInput& input, std::size_t points, SurfaceNodes& nodes) {
  const double per_node = static_cast<double>(points) / static_cast<double>(nodes.size());
  FittedNodes fitted;
  fitted.of = std::move(nodes.of);
  fitted.count = nodes.size();
  fitted.spacing = input.spacing * std::sqrt(per_node);
  return fitted;
}

/// Of each node, whether any of its points is one of some.
std::vector<std::uint8_t> nodes_of_some(const FittedNodes& nodes,
                                        std::span<const std::uint8_t> some) {
  std::vector<std::uint8_t> of_nodes(nodes.count);
  for (std::uint32_t i = 0; i < some.size(); ++i) {
    if (some[i] != 0) of_nodes[nodes.of_point(i)] = 1;
  }
  return of_nodes;
}

/// The sheets of one pass and the nodes that they were fitted to. No more: what fits are made of
/// takes several times the memory of the points, and landing must not have it beside its own.
struct Fitted {
  FittedNodes nodes;
  FitSteps steps;
  NodeSheets sheets;
};

/// Fits the points where the pilot has them, to learn how fits fare.
Fitted survey_points(const AutomaticInput& input, AutomaticResult& pilot, ScaleSurvey& scales,
                     const Execution& execution) {
  // Nodes that are points have the very same places and normals.
  const bool lent = !is_dense(input);
  SurfaceNodes nodes = lent
                           ? nodes_of_points({input.points.begin(), input.points.end()},
                                             std::move(pilot.points), std::move(pilot.normals))
                           : merge(input, input.points, pilot.points, pilot.normals, {}, execution);
  Fitted fitted{describe(input, input.points.size(), nodes), {}, {}};
  const double spacing = fitted.nodes.spacing;
  NodeLevels levels(std::move(nodes), spacing, input.noise,
                    sub_execution(execution, "fits", 0, 0.1));
  fitted.steps = fit_steps(input.noise / spacing, !lent, input.parts);
  Survey survey = survey_nodes(levels, input.noise, fitted.steps.survey, input.parts,
                               sub_execution(execution, "fits", 0.1, 1));
  fitted.sheets = std::move(survey.sheets);
  scales = std::move(survey.scales);
  nodes = std::move(levels).take_nodes();
  if (lent) {
    pilot.points = std::move(nodes.places);
    pilot.normals = std::move(nodes.normals);
  } else if (input.parts.second_pass) {
    // What points land at here is not the result, so those of a node may do so together.
    fitted.nodes.measured = std::move(nodes.measured);
    fitted.nodes.places = std::move(nodes.places);
    fitted.nodes.normals = std::move(nodes.normals);
  }
  return fitted;
}

/// Fits what every sheet has of the points.
/// @param[out] by_edge  of each node, whether it is by an edge
Fitted fit_shares(const AutomaticInput& input, const FitSteps& steps, const ScaleSurvey& scales,
                  Shares shares, AutomaticResult& result, std::vector<std::uint8_t>& by_edge,
                  const Execution& execution) {
  // Nodes that are shares have the very same places and normals.
  const bool lent = !is_dense(input);
  std::optional<LentResult> kept;
  if (lent) kept.emplace(input, shares, result, execution);
  const std::size_t points = shares.measured.size();
  SurfaceNodes nodes =
      lent ? nodes_of_points(std::move(shares.measured), std::move(shares.places),
                             std::move(shares.normals), std::move(shares.trust))
           : merge(input, shares.measured, shares.places, shares.normals, shares.trust, execution);
  Fitted fitted{describe(input, points, nodes), steps, {}};
  by_edge = nodes_of_some(fitted.nodes, shares.by_edge);
  shares = {};
  NodeLevels levels(std::move(nodes), fitted.nodes.spacing, input.noise,
                    sub_execution(execution, "fits", 0, 0.1));
  fitted.sheets = fit_nodes(scales, levels, by_edge, input.noise, steps, input.parts,
                            sub_execution(execution, "fits", 0.1, 1));
  if (kept) {
    nodes = std::move(levels).take_nodes();
    kept->give_back(std::move(nodes.places), std::move(nodes.normals), result, execution);
  }
  return fitted;
}

/// What neither the pilot nor fits found to be of any surface stays where it was measured.
void keep_lone(const AutomaticInput& input, std::span<const std::uint8_t> lone,
               AutomaticResult& result) {
  for (std::size_t i = 0; i < lone.size(); ++i) {
    if (lone[i] == 0) continue;
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
  std::vector<std::uint8_t> lone;
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
  ScaleSurvey survey;
  Fitted first = clock.time(
      "fits", [&] { return survey_points(input, result, survey, part("fits", 0.4, 0.6)); });
  Shares shares;
  clock.time("landing", [&] {
    land(input, first.nodes, std::move(first.sheets), {first.steps.survey, first.steps.around, {}},
         lone, result, &shares, part("landing", 0.6, 0.65));
    return 0;
  });
  if (input.parts.second_pass) {
    std::vector<std::uint8_t> by_edge;
    Fitted second = clock.time("fits", [&] {
      return fit_shares(input, first.steps, survey, std::move(shares), result, by_edge,
                        part("fits", 0.65, 0.9));
    });
    survey = {};
    clock.time("landing", [&] {
      land(input, second.nodes, std::move(second.sheets),
           {second.steps.even, second.steps.around, by_edge}, lone, result, nullptr,
           part("landing", 0.9, 1));
      return 0;
    });
  }
  keep_lone(input, lone, result);
  return result;
}

}  // namespace deburr

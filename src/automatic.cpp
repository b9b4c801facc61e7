// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "automatic.hpp"

#include <algorithm>
#include <cmath>

#include "kd_tree.hpp"
#include "landing.hpp"
#include "node_levels.hpp"
#include "parallel.hpp"
#include "pilot.hpp"
#include "scale_choice.hpp"
#include "sheet_fit.hpp"
#include "surface_nodes.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Side of a node's cell where points are merged, in standard deviations of the noise.
constexpr double node_cell = 1.0;

/// Every so many-th node is fitted at all scales in the first pass.
constexpr std::size_t survey_step = 3;

/// Fits so large overlap so much that one of every so many does.
constexpr std::size_t wide_scale = level_scales + 2;
constexpr std::size_t wide_step = 4;

NodeLevels make_levels(const AutomaticInput& input, Points measured, Points places, Normals normals,
                       std::span<const double> trust, const Execution& execution) {
  SurfaceNodes nodes = is_dense(input) ? merge_into_cells(measured, places, normals, {}, trust,
                                                          node_cell * input.noise, 1, execution)
                                       : nodes_of_points(measured, places, normals, trust);
  const double per_node = static_cast<double>(measured.size()) / static_cast<double>(nodes.size());
  return {std::move(nodes), input.spacing * std::sqrt(per_node), input.noise, execution};
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
  const SheetFitter surveyor(first, input.noise, input.parts);
  std::vector<Sheet> sheets(first.nodes(0).size());
  // What fits of every size tell is pooled over many nodes, so not every node has to be asked.
  std::vector<Vec3> surveyed((sheets.size() + survey_step - 1) / survey_step);
  std::vector<Sheet> surveyed_sheets(surveyed.size());
  std::vector<ScaleCurve> curves(surveyed.size());
  clock.time("fits", [&] {
    ScaleChoice small;
    small.scale = level_scales - 1;
    small.noise = input.noise;
    small.curvature.fill(-1);
    parallel_blocks(sheets.size(), part("fits", 0.42, 0.6),
                    [&](std::size_t begin, std::size_t end) {
                      SheetFitter::Scratch scratch;
                      surveyor.expect(begin, end, scratch);
                      for (std::size_t i = begin; i < end; ++i) {
                        const auto node = static_cast<std::uint32_t>(i);
                        if (i % survey_step != 0) {
                          sheets[i] = surveyor.fit(node, scratch, small);
                          continue;
                        }
                        const std::size_t at = i / survey_step;
                        sheets[i] = surveyor.survey(node, scratch, curves[at]);
                        surveyed[at] = first.nodes(0).places[i];
                        surveyed_sheets[at] = sheets[i];
                      }
                    });
    return 0;
  });
  const Shares shares = clock.time(
      "landing", [&] { return land(input, first, sheets, result, part("landing", 0.6, 0.65)); });
  if (!input.parts.second_pass) {
    keep_lone(input, lone, result);
    return result;
  }

  const NodeLevels second = make_levels(input, shares.measured, shares.places, shares.normals,
                                        shares.trust, part("fits", 0.65, 0.67));
  clock.time("fits", [&] {
    const std::vector<ScaleChoice> choices = choose_scales(
        KdTree(surveyed, execution), surveyed_sheets, curves, second.nodes(0).places,
        second.nodes(0).normals, input.noise, first, part("fits", 0.67, 0.72), input.parts);
    const SheetFitter fitter(second, input.noise, input.parts);
    sheets.assign(second.nodes(0).size(), {});
    // A node without a fit needs the sheets of others.
    const std::size_t step = input.parts.surer_sheet && input.parts.blend ? wide_step : 1;
    parallel_blocks(sheets.size(), part("fits", 0.72, 0.9),
                    [&](std::size_t begin, std::size_t end) {
                      SheetFitter::Scratch scratch;
                      fitter.expect(begin, end, scratch);
                      for (std::size_t i = begin; i < end; ++i) {
                        if (i % step != 0 && choices[i].scale >= wide_scale) continue;
                        sheets[i] = fitter.fit(static_cast<std::uint32_t>(i), scratch, choices[i]);
                      }
                    });
    return 0;
  });
  clock.time("landing",
             [&] { return land(input, second, sheets, result, part("landing", 0.9, 1)); });
  keep_lone(input, lone, result);
  return result;
}

}  // namespace deburr

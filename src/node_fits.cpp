// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "node_fits.hpp"

#include "parallel.hpp"
#include "scale_choice.hpp"

namespace deburr {
namespace {

/// Of the nodes that are fitted in the first pass, one of so many is at all scales: what these tell
/// is pooled over many nodes.
constexpr std::size_t all_scales_step = 2;

/// A node by an edge takes the scale chosen for one close to it, if that is of the same face.
constexpr double same_face = 0.7;

/// Calls fit(node, scratch) for every node; the valid sheets, in the order of the nodes.
template <typename Fit>
NodeSheets fit_each(const SheetFitter& fitter, std::size_t nodes, std::size_t even_step,
                    const Execution& execution, const Fit& fit) {
  std::vector<NodeSheets> blocks((nodes + block_size - 1) / block_size);
  parallel_blocks(nodes, execution, [&](std::size_t begin, std::size_t end) {
    SheetFitter::Scratch scratch;
    fitter.expect(begin, end, scratch);
    NodeSheets& block = blocks[begin / block_size];
    for (std::size_t i = begin; i < end; ++i) {
      const auto node = static_cast<std::uint32_t>(i);
      const Sheet sheet = fit(node, scratch);
      if (sheet.valid) (i % even_step == 0 ? block.even : block.further).push_back({node, sheet});
    }
  });
  NodeSheets all;
  for (NodeSheets& block : blocks) {
    all.even.insert(all.even.end(), block.even.begin(), block.even.end());
    all.further.insert(all.further.end(), block.further.begin(), block.further.end());
    block = {};
  }
  return all;
}

}  // namespace

FitSteps fit_steps(double ratio, const AutomaticParts& parts) {
  // Who leaves out what takes the place of a missing sheet needs that of every node.
  if (!parts.surer_sheet || !parts.blend) return {1, 1, 1};
  if (ratio < 0.35) return {1, 1, 1};
  if (ratio < 0.6) return {2, 2, 1};
  return {3, 8, 2};
}

Survey survey_nodes(const NodeLevels& levels, double noise, std::size_t step,
                    const AutomaticParts& parts, const Execution& execution) {
  const SurfaceNodes& nodes = levels.nodes(0);
  const SheetFitter fitter(levels, noise, parts);
  const std::size_t all_scales = all_scales_step * step;
  Survey survey;
  survey.places.resize((nodes.size() + all_scales - 1) / all_scales);
  survey.fits.resize(survey.places.size());
  survey.curves.resize(survey.places.size());
  ScaleChoice small;
  small.scale = level_scales - 1;
  small.noise = noise;
  small.curvature.fill(-1);
  survey.sheets = fit_each(fitter, nodes.size(), step, execution,
                           [&](std::uint32_t i, SheetFitter::Scratch& scratch) -> Sheet {
                             if (i % step != 0) return {};
                             if (i % all_scales != 0) return fitter.fit(i, scratch, small);
                             const std::size_t at = i / all_scales;
                             survey.places[at] = nodes.places[i];
                             survey.fits[at] = fitter.survey(i, scratch, survey.curves[at]);
                             return survey.fits[at];
                           });
  return survey;
}

NodeSheets fit_nodes(const NodeLevels& first, const Survey& survey, const NodeLevels& second,
                     std::span<const std::uint8_t> by_edge, double noise, const FitSteps& steps,
                     const AutomaticParts& parts, const Execution& execution) {
  const SurfaceNodes& nodes = second.nodes(0);
  std::vector<Vec3> places;
  std::vector<Vec3> normals;
  for (std::size_t i = 0; i < nodes.size(); i += steps.even) {
    places.push_back(nodes.places[i]);
    normals.push_back(nodes.normals[i]);
  }
  const std::vector<ScaleChoice> choices =
      choose_scales(KdTree(survey.places, execution), survey.fits, survey.curves, places, normals,
                    noise, first, sub_execution(execution, "fits", 0, 0.2), parts);
  const SheetFitter fitter(second, noise, parts);
  return fit_each(fitter, nodes.size(), steps.even, sub_execution(execution, "fits", 0.2, 1),
                  [&](std::uint32_t i, SheetFitter::Scratch& scratch) -> Sheet {
                    const std::size_t even = i / steps.even;
                    const bool chosen = i % steps.even == 0;
                    const bool further = by_edge[i] != 0 && i % steps.edges == 0 &&
                                         dot(nodes.normals[i], normals[even]) >= same_face;
                    if (!chosen && !further) return {};
                    return fitter.fit(i, scratch, choices[even]);
                  });
}

}  // namespace deburr

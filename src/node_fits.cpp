// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "node_fits.hpp"

#include <algorithm>

#include "parallel.hpp"
#include "sheet_fit.hpp"

namespace deburr {
namespace {

/// One of so many nodes is fitted at all scales in the first pass: what these tell is pooled over
/// many of them. A multiple of any step of that pass.
constexpr std::size_t all_scales = 6;

/// A node by an edge takes the scale chosen for one close to it, if that is of the same face.
constexpr double same_face = 0.7;

/// Takes out the sheets of nodes that nothing could be fitted to.
void keep_valid(NodeSheets& all) {
  std::size_t kept = 0;
  std::size_t even = 0;
  for (std::size_t k = 0; k < all.sheets.size(); ++k) {
    if (!all.sheets[k].valid) continue;
    if (k < all.even) ++even;
    all.nodes[kept] = all.nodes[k];
    all.sheets[kept++] = all.sheets[k];
  }
  all.sheets.resize(kept);
  all.nodes.resize(kept);
  all.even = even;
}

/// Fits one of every `even_step` nodes, and then further ones.
/// @param further  ascending
/// @param fit_of_block  takes the first node of a block and the one after its last, and returns
///                      what fits a node of it, in their order, given it and the buffers
template <typename FitOfBlock>
NodeSheets fit_each(const SheetFitter& fitter, std::size_t nodes, std::size_t even_step,
                    const std::vector<std::uint32_t>& further, const Execution& execution,
                    const FitOfBlock& fit_of_block) {
  NodeSheets all;
  all.even = (nodes + even_step - 1) / even_step;
  all.nodes.reserve(all.even + further.size());
  for (std::size_t i = 0; i < nodes; i += even_step) {
    all.nodes.push_back(static_cast<std::uint32_t>(i));
  }
  all.nodes.insert(all.nodes.end(), further.begin(), further.end());
  all.sheets.resize(all.nodes.size());
  parallel_blocks(nodes, execution, [&](std::size_t begin, std::size_t end) {
    SheetFitter::Scratch scratch;
    fitter.expect(begin, end, scratch);
    auto fit = fit_of_block(begin, end);
    std::size_t even = (begin + even_step - 1) / even_step;
    auto next =
        static_cast<std::size_t>(std::ranges::lower_bound(further, begin) - further.begin());
    // In their order in space: the search for one helps that for the next.
    for (std::size_t i = begin; i < end; ++i) {
      const auto node = static_cast<std::uint32_t>(i);
      if (i % even_step == 0) {
        all.sheets[even++] = fit(node, scratch);
      } else if (next < further.size() && further[next] == node) {
        all.sheets[all.even + next++] = fit(node, scratch);
      }
    }
  });
  keep_valid(all);
  return all;
}

/// The nodes that a choice of so many leaves out, but that are to be fitted as they are by edges.
std::vector<std::uint32_t> further_nodes(const SurfaceNodes& nodes,
                                         std::span<const std::uint8_t> by_edge,
                                         const FitSteps& steps) {
  std::vector<std::uint32_t> further;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (by_edge[i] == 0 || i % steps.even == 0 || i % steps.edges != 0) continue;
    const Vec3& chosen = nodes.normals[i - i % steps.even];
    if (dot(nodes.normals[i], chosen) >= same_face)
      further.push_back(static_cast<std::uint32_t>(i));
  }
  return further;
}

}  // namespace

FitSteps fit_steps(double ratio, bool merged, const AutomaticParts& parts) {
  // Who leaves out what takes the place of a missing sheet needs that of every node.
  if (!parts.surer_sheet || !parts.blend) return {1, 1, 1, 100};
  const bool little = ratio < 0.35;
  if (!merged) return {2, little ? 1U : 2U, 1, 100};
  if (little) return {2, 2, 1, 50};
  if (ratio < 0.95) return {3, 4, 1, ratio < 0.6 ? 50U : 100U};
  return {3, 8, 2, 100};
}

Survey survey_nodes(const NodeLevels& levels, double noise, std::size_t step,
                    const AutomaticParts& parts, const Execution& execution) {
  const SurfaceNodes& nodes = levels.nodes(0);
  const SheetFitter fitter(levels, noise, parts);
  Survey survey;
  ScaleSurvey& scales = survey.scales;
  for (std::size_t level = 0; level < node_levels; ++level) {
    scales.merged[level] = levels.merged(level);
  }
  scales.places.resize((nodes.size() + all_scales - 1) / all_scales);
  scales.normals.resize(scales.places.size());
  scales.curves.resize(scales.places.size());
  ScaleChoice small;
  small.scale = level_scales - 1;
  small.noise = noise;
  small.curvature.fill(-1);
  const auto fit = [&](std::uint32_t i, SheetFitter::Scratch& scratch) {
    if (i % all_scales != 0) return fitter.fit(i, scratch, small);
    const std::size_t at = i / all_scales;
    const Sheet sheet = fitter.survey(i, scratch, scales.curves[at]);
    scales.places[at] = nodes.places[i];
    scales.normals[at] = sheet.frame.w;
    return sheet;
  };
  survey.sheets = fit_each(fitter, nodes.size(), step, {}, execution,
                           [&](std::size_t, std::size_t) { return fit; });
  return survey;
}

NodeSheets fit_nodes(const ScaleSurvey& survey, const NodeLevels& levels,
                     std::span<const std::uint8_t> by_edge, double noise, const FitSteps& steps,
                     const AutomaticParts& parts, const Execution& execution) {
  const SurfaceNodes& nodes = levels.nodes(0);
  const ScaleChooser chooser(survey, noise, parts, execution);
  const SheetFitter fitter(levels, noise, parts);
  const auto fit_of_block = [&](std::size_t begin, std::size_t end) {
    const std::size_t first = begin / steps.even;
    std::vector<Vec3> places;
    std::vector<Vec3> normals;
    for (std::size_t i = first * steps.even; i < end; i += steps.even) {
      places.push_back(nodes.places[i]);
      normals.push_back(nodes.normals[i]);
    }
    return [&, first, choices = chooser.choose(places, normals)](std::uint32_t i,
                                                                 SheetFitter::Scratch& scratch) {
      return fitter.fit(i, scratch, choices[i / steps.even - first]);
    };
  };
  return fit_each(fitter, nodes.size(), steps.even, further_nodes(nodes, by_edge, steps), execution,
                  fit_of_block);
}

}  // namespace deburr

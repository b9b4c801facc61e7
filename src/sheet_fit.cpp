// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "belonging.hpp"
#include "unit.hpp"
#include "weighted_quadric.hpp"

namespace deburr {
namespace {

constexpr std::size_t fine_neighbors = 100;
constexpr std::size_t coarse_neighbors = 150;
constexpr double growth = 1.5;  ///< of the area from one scale to the next

/// The smallest neighbourhood holds so many nodes, or so many for each square of noise over
/// spacing: a patch thinner than the noise has no direction.
constexpr double fewest = 15;
constexpr double fewest_per_noise = 40;

/// A larger fit must agree with every smaller one within so many of its standard deviations.
constexpr double agreement = 2;

/// And its residuals may exceed the noise by so many of their standard deviations.
constexpr double excess = 4;
constexpr double coarse_excess = 2.5;  ///< means of nodes show a misfit more clearly
constexpr double survey_excess = 3;    ///< a survey ends at so many times the variance of the noise

/// Quadratic terms are taken where they take off the squares so many times what noise would let
/// them: for all nodes around together, or for this one on its own.
constexpr float curved_together = 1.5F;
constexpr double curved_alone = 3;
constexpr double curved_unknown = 2;

constexpr std::size_t fewest_samples = 5;

}  // namespace

/// One growing of a sheet.
struct SheetFitter::Run {
  std::uint32_t node;
  Scratch& scratch;
  double noise;
  Sheet sheet;
  double low = -std::numeric_limits<double>::infinity();  ///< what the fits so far agree on
  double high = std::numeric_limits<double>::infinity();
};

Sheet SheetFitter::grow(std::uint32_t i, Scratch& scratch, const ScaleChoice& choice,
                        ScaleCurve* curve) const {
  Run run{i, scratch, choice.noise, {}};
  Sheet& sheet = run.sheet;
  const SurfaceNodes& fine = levels_.nodes(0);
  sheet.frame = frame_along(fine.places[i], fine.normals[i]);
  const double variance = run.noise * run.noise;
  const double reach = height_reach(run.noise, levels_.spacing());

  // The node itself is the nearest.
  scratch.nearest[0].find(levels_.tree(0), fine.places[i], fine_neighbors + 1, scratch.found);
  scratch.samples.start(fine, sheet.frame, scratch.found);
  if (scratch.samples.size() < 2) return sheet;
  const double ratio = run.noise / levels_.spacing();
  const auto first = static_cast<std::size_t>(std::clamp(
      fewest_per_noise * ratio * ratio / fine.weight(i), fewest, double{fine_neighbors}));
  double area = scratch.samples.square(std::min(first, scratch.samples.size() - 1));

  const std::size_t largest = std::min(choice.scale, parts_.levels * level_scales - 1);
  for (std::size_t scale = 0; scale <= largest; ++scale, area *= growth) {
    const std::size_t level = scale / level_scales;
    const bool coarse = level > 0;
    if (coarse && scale % level_scales == 0) {
      // Coarser nodes take over where the finer ones end, wherever that was.
      if (!sheet.valid) break;
      area = sheet.radius * sheet.radius * growth;
      scratch.nearest[level].find(levels_.tree(level), sheet.frame.origin, coarse_neighbors,
                                  scratch.found);
      if (scratch.found.empty() || scratch.found.back().squared_distance < area) break;
      scratch.samples.start(levels_.nodes(level), sheet.frame, scratch.found);
    }
    SheetSamples& samples = scratch.samples;
    const double farthest = samples.square(samples.size() - 1);
    const bool last = !(area < farthest);
    if (last) area = farthest;
    WeightedQuadric sums(std::sqrt(area));
    samples.sum(samples.count_within(area), {sheet.height, area, reach, normal_reach}, sums);
    const std::size_t next = last ? (level + 1) * level_scales - 1 : scale;
    if (sums.count() < fewest_samples) {
      if (last && !sheet.valid) break;
      scale = next;
      continue;
    }
    const WeightedQuadric::Solver solver = sums.solve();
    const double bend = solver.curvature() / variance;
    const float pooled = choice.curvature[scale];
    const bool curved = curve != nullptr || pooled < 0
                            ? bend > curved_unknown
                            : pooled > curved_together || bend > curved_alone;
    const WeightedQuadric::Solution best = curved ? solver.quadric() : solver.plane();
    const double pulled = samples.variance(best.pull);
    if (curve != nullptr) {
      curve->residual[scale] = static_cast<float>(best.residual / variance);
      curve->freedom[scale] = static_cast<float>(best.freedom);
      curve->variance[scale] = static_cast<float>(pulled);
      curve->curvature[scale] = static_cast<float>(bend);
      if (sheet.valid && best.residual > survey_excess * variance) break;
    } else if (parts_.guards) {
      const double height = best.surface.c[0];
      const double deviation = agreement * run.noise * std::sqrt(pulled);
      const double low = std::max(run.low, height - deviation);
      const double high = std::min(run.high, height + deviation);
      const double most = 1 + (coarse ? coarse_excess : excess) * std::sqrt(2 / best.freedom);
      if (low > high || (sheet.valid && best.residual > most * variance)) break;
      run.low = low;
      run.high = high;
    }
    sheet.height = best.surface;
    sheet.variance = std::max(pulled, std::numeric_limits<double>::min()) * variance;
    sheet.radius = std::sqrt(area);
    sheet.valid = true;
    scale = next;
  }
  return sheet;
}

Sheet SheetFitter::survey(std::uint32_t i, Scratch& scratch, ScaleCurve& curve) const {
  curve = {};
  ScaleChoice choice;
  choice.noise = noise_;
  return is_zero(levels_.nodes(0).normals[i]) ? Sheet{} : grow(i, scratch, choice, &curve);
}

Sheet SheetFitter::fit(std::uint32_t i, Scratch& scratch, const ScaleChoice& choice) const {
  return is_zero(levels_.nodes(0).normals[i]) ? Sheet{} : grow(i, scratch, choice, nullptr);
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "automatic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "corners.hpp"
#include "crease.hpp"
#include "kd_tree.hpp"
#include "parallel.hpp"
#include "pilot.hpp"
#include "scale_choice.hpp"
#include "sheet_blend.hpp"
#include "sheet_fit.hpp"
#include "surface_nodes.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Side of a node's cell where points are merged, in standard deviations of the noise.
constexpr double node_cell = 1.0;

/// Less of a point is not worth a place among the nodes of another sheet.
constexpr double least_share = 0.02;

/// Every so many-th node is fitted at all scales in the first pass.
constexpr std::size_t survey_step = 3;

constexpr std::size_t blended = 100;  ///< nodes around a point that its landing is made of
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Every point on the sheets that it may be of: first each on the likeliest, then what is left.
struct Shares {
  std::vector<Vec3> measured;
  std::vector<Vec3> places;
  std::vector<Vec3> normals;
  std::vector<double> trust;
};

/// A point on a sheet that is not its likeliest.
struct Other {
  std::uint32_t point;
  CutSheet sheet;
};

NodeLevels make_levels(const AutomaticInput& input, Points measured, Points places, Normals normals,
                       std::span<const double> trust, const Execution& execution) {
  SurfaceNodes nodes = is_dense(input) ? merge_into_cells(measured, places, normals, {}, trust,
                                                          node_cell * input.noise, 1, execution)
                                       : nodes_of_points(measured, places, normals, trust);
  const double per_node = static_cast<double>(measured.size()) / static_cast<double>(nodes.size());
  return {std::move(nodes), input.spacing * std::sqrt(per_node), input.noise, execution};
}

/// The node whose sheet stands for a point: its own, unless that is far less sure than those
/// around. Then the own normal was none of a surface, and the nearest sure sheet that the noise
/// lets the point be of takes its place.
std::uint32_t surer(const Vec3& point, const Vec3& normal, std::uint32_t own, std::span<const Found> near,
                    std::span<const Sheet> sheets, double noise, std::vector<double>& variances) {
  constexpr double most_ratio = 3;
  constexpr double most_noises = 3;
  variances.clear();
  for (const Found& f : near) {
    if (sheets[f.index].valid) variances.push_back(sheets[f.index].variance);
  }
  if (variances.empty()) return own;
  const auto quarter = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 4);
  std::ranges::nth_element(variances, quarter);
  const double most = most_ratio * *quarter;
  if (sheets[own].valid && sheets[own].variance <= most) return own;
  if (!sheets[own].valid && getenv("NO")) {
    for (const Found& f : near) {
      const Sheet& sheet = sheets[f.index];
      if (!sheet.valid || sheet.variance > most || dot(sheet.frame.w, normal) < 0.8) continue;
      if (std::abs(sheet.meet(point).distance) <= most_noises * noise) return f.index;
    }
  }
  for (const Found& f : near) {
    const Sheet& sheet = sheets[f.index];
    if (!sheet.valid || sheet.variance > most) continue;
    if (std::abs(sheet.meet(point).distance) <= most_noises * noise) return f.index;
  }
  return own;
}

/// Lands every point on the sheets around it.
Shares land(const AutomaticInput& input, const NodeLevels& levels, std::span<const Sheet> sheets,
            AutomaticResult& result, const Execution& execution) {
  const BlendScales scales{input.noise, levels.spacing()};
  const CreaseFinder finder(sheets, scales, input.spacing);
  Shares shares;
  shares.measured.assign(input.points.begin(), input.points.end());
  shares.places.resize(input.points.size());
  shares.normals.resize(input.points.size());
  shares.trust.resize(input.points.size());
  std::vector<std::vector<Other>> others((input.points.size() + block_size - 1) / block_size);
  std::vector<Vec3> places(result.points);
  std::vector<std::vector<EdgePoint>> edge_blocks(others.size());
  parallel_blocks(input.points.size(), execution, [&](std::size_t begin, std::size_t end) {
    std::vector<Found> near;
    std::vector<double> variances;
    for (std::size_t i = begin; i < end; ++i) {
      std::uint32_t own = levels.nodes(0).of[i];
      levels.tree(0).nearest_to(result.points[i], blended, infinity, near);
      if (!near.empty()) own = surer(input.points[i], result.normals[i], own, near, sheets, input.noise, variances);
      const Blend blend =
          blend_sheets(input.points[i], result.points[i], own, near, sheets, scales);
      // Without a fit the place so far is the best that is known.
      Landing landing{result.points[i], result.normals[i]};
      landing.sheets[0] = {result.points[i], result.normals[i]};
      if (blend.valid && is_finite(blend.foot)) {
        landing = finder.land(input.points[i], blend, own, near);
      }
      const Vec3 move = landing.place - input.points[i];
      const double distance = norm(move);
      places[i] = distance > input.max_move ? input.points[i] + (input.max_move / distance) * move
                                            : landing.place;
      result.normals[i] = landing.normal;
      result.labels[i] = landing.label;
      if (landing.label == Feature::Edge || landing.label == Feature::Corner) {
        edge_blocks[begin / block_size].push_back(
            {static_cast<std::uint32_t>(i), landing.sheets, landing.sheet_count});
      }
      const std::span<const CutSheet> here(landing.sheets.data(), landing.sheet_count);
      const auto likeliest = std::ranges::max_element(here, {}, &CutSheet::share);
      shares.places[i] = likeliest->foot;
      shares.normals[i] = likeliest->normal;
      shares.trust[i] = likeliest->share;
      for (auto s = here.begin(); s != here.end(); ++s) {
        if (s != likeliest && s->share > least_share) {
          others[begin / block_size].push_back({static_cast<std::uint32_t>(i), *s});
        }
      }
    }
  });
  for (const auto& block : others) {
    for (const Other& other : block) {
      shares.measured.push_back(input.points[other.point]);
      shares.places.push_back(other.sheet.foot);
      shares.normals.push_back(other.sheet.normal);
      shares.trust.push_back(other.sheet.share);
    }
  }
  result.points = std::move(places);
  std::vector<EdgePoint> edges;
  for (const auto& block : edge_blocks) edges.insert(edges.end(), block.begin(), block.end());
  label_corners(edges, result.points, input.spacing, result.labels, execution);
  return shares;
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

  // A first pass tells how fits of every size fare, the second takes the best of them.
  const NodeLevels first =
      make_levels(input, input.points, result.points, result.normals, {}, part("fits", 0.4, 0.42));
  const SheetFitter surveyor(first, input.noise);
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
                      for (std::size_t i = begin; i < end; ++i) {
                        const auto node = static_cast<std::uint32_t>(i);
                        if (i % survey_step != 0) {
                          if (!getenv("SKIP1")) sheets[i] = surveyor.fit(node, scratch, small);
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

  const NodeLevels second = make_levels(input, shares.measured, shares.places, shares.normals,
                                        shares.trust, part("fits", 0.65, 0.67));
  clock.time("fits", [&] {
    const std::vector<ScaleChoice> choices =
        choose_scales(KdTree(surveyed, execution), surveyed_sheets, curves, second.nodes(0).places,
                      second.nodes(0).normals, input.noise, first, part("fits", 0.67, 0.72));
    const SheetFitter fitter(second, input.noise);
    sheets.assign(second.nodes(0).size(), {});
    parallel_blocks(sheets.size(), part("fits", 0.72, 0.9),
                    [&](std::size_t begin, std::size_t end) {
                      SheetFitter::Scratch scratch;
                      for (std::size_t i = begin; i < end; ++i) {
                        static const std::size_t T = getenv("T") ? atoi(getenv("T")) : 0;
                        static const std::size_t ST = getenv("ST") ? atoi(getenv("ST")) : 4;
                        if (choices[i].scale >= T && i % ST != 0) continue;
                        sheets[i] = fitter.fit(static_cast<std::uint32_t>(i), scratch, choices[i]);
                      }
                    });
    return 0;
  });
  clock.time("landing",
             [&] { return land(input, second, sheets, result, part("landing", 0.9, 1)); });
  for (std::size_t i = 0; i < lone.size(); ++i) {
    if (!lone[i]) continue;
    result.points[i] = input.points[i];
    result.labels[i] = Feature::Isolated;
  }
  return result;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/outliers.hpp"

#include <algorithm>

#include "columns.hpp"
#include "kd_tree.hpp"
#include "outlier_graph.hpp"
#include "outlier_surface.hpp"
#include "outlier_threshold.hpp"
#include "outliers_of_distinct.hpp"
#include "parallel.hpp"
#include "require.hpp"
#include "some_points.hpp"
#include "working_set.hpp"

namespace deburr {
namespace {

constexpr std::size_t fewest_points = 64;

/// Points of a small group are at most this share of the cloud.
constexpr std::size_t small_share = 8;

/// Up to this rough score a point is surely no outlier.
constexpr double sure = 2.2;

/// Distance of every point from the surface, over the noise there.
std::vector<double> scores(Points points, const Execution& execution) {
  const KdTree tree(points, execution);
  const std::size_t small = std::min(most_floaters, points.size() / small_share);
  const std::vector<Standing> standing =
      join_points(points, tree, small, sub_execution(execution, "outliers", 0.05, 0.5));
  const SomePoints support(
      points, tree, [&](std::size_t i) { return standing[i] == Standing::Surface; }, execution);
  auto scores = make_column<double>(points.size(), execution);
  if (support.points().size() < fewest_points) return scores;

  const RoughSurface surface(support, sub_execution(execution, "outliers", 0.5, 0.8));
  parallel_for(points.size(), sub_execution(execution, "outliers", 0.8, 1), [&](std::size_t i) {
    if (standing[i] == Standing::Patch) return;
    const std::uint32_t place = support.place(static_cast<std::uint32_t>(i));
    if (place != no_point) scores[i] = surface.rough_score(place);
    if (place != no_point && scores[i] <= sure) return;
    scores[i] = surface.fine_score(points[i], place);
  });
  return scores;
}

}  // namespace

std::vector<std::uint8_t> find_outliers_of_distinct(Points points, const OutlierOptions& options,
                                                    const Execution& execution) {
  std::vector<std::uint8_t> outlier(points.size());
  if (points.size() < fewest_points) return outlier;
  const std::vector<double> score = scores(points, execution);
  const double most = options.tolerance * score_threshold(score, without_progress(execution));
  parallel_for(points.size(), without_progress(execution),
               [&](std::size_t i) { outlier[i] = score[i] > most ? 1 : 0; });
  return outlier;
}

std::vector<std::uint8_t> find_outliers(Points points, const OutlierOptions& options,
                                        const Execution& execution) {
  require(options.tolerance >= 0.1 && options.tolerance <= 10, "outliers.tolerance", "in [0.1, 10]",
          options.tolerance);
  require(points.size() < no_point, "points", "fewer than 2^32 - 1", points.size());
  PointCloud cloud;
  cloud.points.assign(points.begin(), points.end());
  const WorkingSet set = make_working_set(cloud, {}, sub_execution(execution, "outliers", 0, 0.05));
  const std::vector<std::uint8_t> of_set =
      find_outliers_of_distinct(set.points, options, execution);
  std::vector<std::uint8_t> outlier(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (set.slot[i] != WorkingSet::none) outlier[i] = of_set[set.slot[i]];
  }
  return outlier;
}

}  // namespace deburr

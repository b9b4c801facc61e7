// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/outliers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "box.hpp"
#include "kd_tree.hpp"
#include "outlier_graph.hpp"
#include "outlier_surface.hpp"
#include "outlier_threshold.hpp"
#include "parallel.hpp"
#include "require.hpp"
#include "spatial_order.hpp"

namespace deburr {
namespace {

constexpr std::size_t fewest_points = 64;

/// Points of a small group are at most this share of the cloud.
constexpr std::size_t small_share = 8;

/// Up to this rough score a point is surely no outlier.
constexpr double sure = 2.2;

/// The finite points, each place once, around the origin and within a box of about two.
struct Places {
  std::vector<Vec3> points;
  std::vector<std::uint32_t> from;  ///< the index of a point that was given
  std::vector<std::uint32_t> to;    ///< where it is in `points`
};

Places distinct_places(Points points, const Execution& execution) {
  Places places;
  std::vector<Vec3> finite;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) continue;
    places.from.push_back(static_cast<std::uint32_t>(i));
    finite.push_back(points[i]);
  }
  if (finite.empty()) return places;
  const Box box = bounding_box(finite);
  const Vec3 center = middle(box);
  const Vec3 half = half_extent(box);
  // By a power of two, which rounds nothing; squares of distances then neither overflow nor vanish.
  int exponent = 0;
  std::frexp(std::max({half.x, half.y, half.z}), &exponent);
  const auto normed = [&](double v, double middle) {
    return std::ldexp(0.5 * v - 0.5 * middle, 1 - exponent);
  };
  places.to.resize(finite.size());
  Vec3 last;
  for (const std::uint32_t i :
       spatial_order(finite, sub_execution(execution, "outliers", 0, 0.05))) {
    const Vec3& p = finite[i];
    if (places.points.empty() || p != last) {
      places.points.push_back(
          {normed(p.x, center.x), normed(p.y, center.y), normed(p.z, center.z)});
    }
    last = p;
    places.to[i] = static_cast<std::uint32_t>(places.points.size() - 1);
  }
  return places;
}

/// Distance of every point from the surface, over the noise there.
std::vector<double> scores(Points points, const Execution& execution) {
  const KdTree tree(points, execution);
  const std::size_t small = std::min(most_floaters, points.size() / small_share);
  const std::vector<Standing> standing =
      join_points(points, tree, small, sub_execution(execution, "outliers", 0.05, 0.5));
  std::vector<Vec3> support;
  std::vector<std::uint32_t> place(points.size(), no_point);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (standing[i] != Standing::Surface) continue;
    place[i] = static_cast<std::uint32_t>(support.size());
    support.push_back(points[i]);
  }
  std::vector<double> scores(points.size());
  if (support.size() < fewest_points) return scores;

  // A tree of its own: the boxes of the other are stretched by what is off the surface.
  const KdTree support_tree(support, execution);
  const RoughSurface surface(support, support_tree, sub_execution(execution, "outliers", 0.5, 0.8));
  parallel_for(points.size(), sub_execution(execution, "outliers", 0.8, 1), [&](std::size_t i) {
    if (standing[i] == Standing::Patch) return;
    if (place[i] != no_point) scores[i] = surface.rough_score(place[i]);
    if (place[i] != no_point && scores[i] <= sure) return;
    scores[i] = surface.fine_score(points[i], place[i]);
  });
  return scores;
}

}  // namespace

std::vector<std::uint8_t> find_outliers(Points points, const OutlierOptions& options,
                                        const Execution& execution) {
  require(options.tolerance >= 0.1 && options.tolerance <= 10, "outliers.tolerance", "in [0.1, 10]",
          options.tolerance);
  require(points.size() < no_point, "points", "fewer than 2^32 - 1", points.size());
  std::vector<std::uint8_t> outlier(points.size());
  const Places places = distinct_places(points, execution);
  if (places.points.size() < fewest_points) return outlier;
  const std::vector<double> score = scores(places.points, execution);
  const double most = options.tolerance * score_threshold(score);
  for (std::size_t i = 0; i < places.from.size(); ++i) {
    outlier[places.from[i]] = score[places.to[i]] > most ? 1 : 0;
  }
  return outlier;
}

}  // namespace deburr

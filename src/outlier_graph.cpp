// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outlier_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "cell_grid.hpp"
#include "columns.hpp"
#include "joined_sets.hpp"
#include "outlier_patch.hpp"
#include "parallel.hpp"
#include "quantile.hpp"

namespace deburr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr std::size_t links = 6;
using Links = std::array<std::uint32_t, links>;

/// Reaches of two points that are joined differ by no more than this factor.
constexpr double steepest = 2;

/// A point this many times farther from others than nine tenths of the points is scattered.
constexpr double scattered = 3;

/// Fewest points of a small group that may be a piece of surface, and its thickness over its width.
/// A ball has 1.
constexpr std::size_t fewest_in_patch = 16;
constexpr double flat = 0.25;

double longest_reach(std::vector<double> reach) {
  const auto tenth = reach.begin() + static_cast<std::ptrdiff_t>(9 * reach.size() / 10);
  std::nth_element(reach.begin(), tenth, reach.end());
  return scattered * *tenth;
}

/// A radius within which most points have their links, from those of some.
double usual_radius(Points points, const KdTree& tree) {
  constexpr std::size_t samples = 512;
  constexpr double margin = 1.7;
  const std::size_t step = (points.size() + samples - 1) / samples;
  std::vector<double> squares;
  std::vector<Found> found;
  for (std::size_t at = 0; at < points.size(); at += step) {
    tree.nearest(tree.order()[at], links, infinity, found);
    squares.push_back(found.back().squared_distance);
  }
  return margin * std::sqrt(quantile(std::move(squares), 0.5));
}

/// The nearest of every point: in a grid where it has enough within a usual radius, else in the
/// tree.
void find_links(Points points, const KdTree& tree, std::vector<Links>& nearest,
                std::vector<double>& reach, const Execution& execution) {
  const auto set = [&](std::uint32_t i, std::span<const Found> found) {
    for (std::size_t k = 0; k < links; ++k) nearest[i][k] = found[k].index;
    reach[i] = std::sqrt(found.back().squared_distance);
  };
  const std::optional<CellGrid> grid =
      CellGrid::make(points, usual_radius(points, tree), links, without_progress(execution));
  parallel_blocks(points.size(), execution, [&](std::size_t begin, std::size_t end) {
    std::vector<Found> in_grid((end - begin) * links);
    std::vector<Found> found;
    if (grid) grid->nearest(begin, end, links, in_grid.data());
    for (std::size_t at = begin; at < end; ++at) {
      // Along the leaves of the tree one search warms the cache for the next.
      const std::uint32_t i = grid ? grid->index(at) : tree.order()[at];
      const auto near = std::span<const Found>(in_grid).subspan((at - begin) * links, links);
      if (grid && near.back().squared_distance < infinity) {
        set(i, near);
        continue;
      }
      tree.nearest(i, links, infinity, found);
      set(i, found);
    }
  });
}

bool is_flat(Points group) {
  return group.size() >= fewest_in_patch && fit_patch(group, group[0]).flatness <= flat;
}

}  // namespace

std::vector<Standing> join_points(Points points, const KdTree& tree, std::size_t small,
                                  const Execution& execution) {
  const std::size_t n = points.size();
  const Execution quiet = without_progress(execution);
  auto nearest = make_column<Links>(n, quiet);
  auto reach = make_column<double>(n, quiet);
  find_links(points, tree, nearest, reach, execution);

  const double longest = longest_reach(reach);
  JoinedSets sets(n, quiet);
  parallel_for(n, quiet, [&](std::size_t at) {
    const auto i = static_cast<std::uint32_t>(at);
    if (reach[i] > longest) return;
    for (const std::uint32_t j : nearest[i]) {
      const double larger = std::max(reach[i], reach[j]);
      if (larger <= longest && larger <= steepest * std::min(reach[i], reach[j])) sets.join(i, j);
    }
  });
  auto group = make_column<std::uint32_t>(n, quiet);
  parallel_for(n, quiet,
               [&](std::size_t i) { group[i] = sets.find(static_cast<std::uint32_t>(i)); });
  auto size = make_column<std::uint32_t>(n, quiet);
  for (const std::uint32_t g : group) ++size[g];

  std::map<std::uint32_t, std::vector<Vec3>> groups;
  std::vector<Standing> standing(n, Standing::Surface);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (size[group[i]] > small) continue;
    standing[i] = Standing::Loose;
    if (size[group[i]] >= fewest_in_patch) groups[group[i]].push_back(points[i]);
  }
  std::erase_if(groups, [](const auto& g) { return !is_flat(g.second); });
  for (std::uint32_t i = 0; i < n; ++i) {
    if (standing[i] == Standing::Loose && groups.contains(group[i])) standing[i] = Standing::Patch;
  }
  return standing;
}

}  // namespace deburr

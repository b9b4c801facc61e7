// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outlier_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "cell_grid.hpp"
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

/// Disjoint sets; the smallest member stands for a set, so that the result is unique.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

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
  std::vector<Links> nearest(n);
  std::vector<double> reach(n);
  find_links(points, tree, nearest, reach, execution);

  const double longest = longest_reach(reach);
  Sets sets(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    if (reach[i] > longest) continue;
    for (const std::uint32_t j : nearest[i]) {
      const double larger = std::max(reach[i], reach[j]);
      if (larger <= longest && larger <= steepest * std::min(reach[i], reach[j])) sets.join(i, j);
    }
  }
  std::vector<std::uint32_t> size(n);
  for (std::uint32_t i = 0; i < n; ++i) ++size[sets.find(i)];

  std::map<std::uint32_t, std::vector<Vec3>> groups;
  std::vector<Standing> standing(n, Standing::Surface);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t group = sets.find(i);
    if (size[group] > small) continue;
    standing[i] = Standing::Loose;
    if (size[group] >= fewest_in_patch) groups[group].push_back(points[i]);
  }
  std::erase_if(groups, [](const auto& group) { return !is_flat(group.second); });
  for (std::uint32_t i = 0; i < n; ++i) {
    if (standing[i] == Standing::Loose && groups.contains(sets.find(i)))
      standing[i] = Standing::Patch;
  }
  return standing;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outlier_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "outlier_patch.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

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

bool is_flat(Points group) {
  return group.size() >= fewest_in_patch && fit_patch(group, group[0]).flatness <= flat;
}

}  // namespace

std::vector<Standing> join_points(Points points, const KdTree& tree, std::size_t small,
                                  const Execution& execution) {
  const std::size_t n = points.size();
  std::vector<Links> nearest(n);
  std::vector<double> reach(n);
  // Along the leaves of the tree one search warms the cache for the next.
  const std::vector<std::uint32_t>& order = tree.order();
  parallel_blocks(n, execution, [&](std::size_t begin, std::size_t end) {
    std::vector<Found> found;
    for (std::size_t at = begin; at < end; ++at) {
      const std::uint32_t i = order[at];
      tree.nearest(i, links, std::numeric_limits<double>::infinity(), found);
      for (std::size_t k = 0; k < links; ++k) nearest[i][k] = found[k].index;
      reach[i] = std::sqrt(found.back().squared_distance);
    }
  });

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

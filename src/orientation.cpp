// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/orientation.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "parallel.hpp"
#include "require.hpp"
#include "spanning_forest.hpp"
#include "spatial_order.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Both directions of edges, as neighbourhoods.
Neighborhoods adjacency(std::size_t n, const std::vector<Edge>& edges, const Execution& execution) {
  CancelWatch watch(execution);
  std::vector<std::size_t> offsets(n + 1);
  for (const Edge& edge : edges) {
    ++offsets[edge.i + 1];
    ++offsets[edge.j + 1];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<std::uint32_t> indices(offsets.back());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  for (const Edge& edge : edges) {
    watch();
    indices[next[edge.i]++] = edge.j;
    indices[next[edge.j]++] = edge.i;
  }
  return {std::move(offsets), std::move(indices)};
}

/// The highest point of each piece, of several the one with the smallest id; by that id.
std::vector<std::uint32_t> highest_points(Points points, std::span<const std::uint32_t> ids,
                                          JoinedSets& pieces, CancelWatch& watch) {
  // A piece is known by its first point, which is met first.
  std::vector<std::uint32_t> highest(points.size());
  std::vector<std::uint32_t> firsts;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    watch();
    const std::uint32_t first = pieces.find(i);
    if (first == i) {
      firsts.push_back(i);
      highest[i] = i;
      continue;
    }
    const std::uint32_t best = highest[first];
    const bool higher = points[i].z > points[best].z;
    if (higher || (points[i].z == points[best].z && ids[i] < ids[best])) highest[first] = i;
  }
  for (std::uint32_t& first : firsts) first = highest[first];
  return firsts;
}

/// Turns normals that belong to points with ids; these only decide between equals.
void orient(Points points, std::span<const std::uint32_t> ids, const Neighborhoods& neighborhoods,
            std::vector<Vec3>& normals, const Execution& execution) {
  JoinedSets pieces(points.size(), execution);
  const Neighborhoods forest = adjacency(
      points.size(), spanning_forest(normals, neighborhoods, ids, pieces, execution), execution);
  CancelWatch watch(execution);
  std::vector<bool> seen(points.size());
  std::vector<std::uint32_t> open;
  for (const std::uint32_t root : highest_points(points, ids, pieces, watch)) {
    seen[root] = true;
    if (points_down(normals[root])) normals[root] = -normals[root];
    open.push_back(root);
    while (!open.empty()) {
      const std::uint32_t parent = open.back();
      open.pop_back();
      watch();
      for (const std::uint32_t child : forest[parent]) {
        if (seen[child]) continue;
        seen[child] = true;
        const double side = dot(normals[child], normals[parent]);
        if (side < 0 || (side == 0 && points_down(normals[child]))) {
          normals[child] = -normals[child];
        }
        open.push_back(child);
      }
    }
  }
}

/// Whether neighbours are mostly near in memory, too; by the nearest of some.
bool is_in_spatial_order(const Neighborhoods& neighborhoods) {
  constexpr std::size_t samples = 256;
  constexpr double near = 0.05;
  const std::size_t n = neighborhoods.size();
  const std::size_t step = std::max<std::size_t>(1, n / samples);
  double apart = 0;
  double count = 0;
  for (std::size_t i = 0; i < n; i += step) {
    if (neighborhoods[i].empty()) continue;
    const std::size_t j = neighborhoods[i].front();
    apart += static_cast<double>(i < j ? j - i : i - j);
    ++count;
  }
  return apart <= near * static_cast<double>(n) * count;
}

/// The neighbourhoods of points in another order, by their places in it.
Neighborhoods in_order(const Neighborhoods& neighborhoods, std::span<const std::uint32_t> order,
                       const Execution& execution) {
  std::vector<std::uint32_t> place(order.size());
  std::vector<std::size_t> offsets(order.size() + 1);
  for (std::uint32_t at = 0; at < order.size(); ++at) {
    place[order[at]] = at;
    offsets[at + 1] = offsets[at] + neighborhoods[order[at]].size();
  }
  std::vector<std::uint32_t> indices(offsets.back());
  parallel_for(order.size(), execution, [&](std::size_t at) {
    std::size_t to = offsets[at];
    for (const std::uint32_t j : neighborhoods[order[at]]) indices[to++] = place[j];
  });
  return {std::move(offsets), std::move(indices)};
}

}  // namespace

std::vector<Vec3> orient_normals(Points points, Normals normals, const Neighborhoods& neighborhoods,
                                 const Execution& execution) {
  require_size("normals", normals.size(), points.size());
  require_size("neighborhoods", neighborhoods.size(), points.size());
  std::vector<Vec3> oriented(normals.begin(), normals.end());
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  if (is_in_spatial_order(neighborhoods) || !std::ranges::all_of(points, is_finite)) {
    orient(points, order, neighborhoods, oriented, execution);
    return oriented;
  }
  // Points at random places in memory take three times as long.
  const Execution quiet = without_progress(execution);
  order = spatial_order(points, quiet);
  std::vector<Vec3> along = gather<Vec3>(normals, order, quiet);
  orient(gather<Vec3>(points, order, quiet), order, in_order(neighborhoods, order, quiet), along,
         quiet);
  for (std::size_t at = 0; at < order.size(); ++at) oriented[order[at]] = along[at];
  return oriented;
}

}  // namespace deburr

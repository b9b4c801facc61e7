// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "parallel.hpp"
#include "require.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

struct Edge {
  double weight;
  std::uint32_t i, j;  ///< i < j

  friend bool operator<(const Edge& a, const Edge& b) {
    if (a.weight != b.weight) return a.weight < b.weight;
    return a.i != b.i ? a.i < b.i : a.j < b.j;
  }
};

/// Union-find with path halving.
class Pieces {
 public:
  explicit Pieces(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Joins the pieces of i and j; false if they are one already.
  bool join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
    return i != j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Every pair of neighbours once. Points without a normal take no part: they could not pass a sign
/// on.
std::vector<Edge> neighbor_graph(Normals normals, const Neighborhoods& neighborhoods,
                                 const Execution& execution) {
  std::vector<Edge> edges;
  edges.reserve(neighborhoods.pair_count());
  for (std::uint32_t i = 0; i < normals.size(); ++i) {
    if (i % block_size == 0) check_cancelled(execution);
    if (is_zero(normals[i])) continue;
    for (const std::uint32_t j : neighborhoods[i]) {
      if (is_zero(normals[j])) continue;
      if (j < i && std::ranges::find(neighborhoods[j], i) != neighborhoods[j].end()) continue;
      edges.push_back({1 - std::abs(dot(normals[i], normals[j])), std::min(i, j), std::max(i, j)});
    }
  }
  return edges;
}

/// Both directions of the edges of the minimum spanning forest (Kruskal), as neighbourhoods.
Neighborhoods spanning_forest(std::size_t n, const std::vector<Edge>& sorted,
                              const Execution& execution) {
  Pieces pieces(n);
  std::vector<Edge> forest;
  std::vector<std::size_t> offsets(n + 1);
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    if (k % block_size == 0) check_cancelled(execution);
    const Edge& edge = sorted[k];
    if (!pieces.join(edge.i, edge.j)) continue;
    forest.push_back(edge);
    ++offsets[edge.i + 1];
    ++offsets[edge.j + 1];
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<std::uint32_t> indices(offsets.back());
  std::vector<std::size_t> next(offsets.begin(), offsets.end() - 1);
  for (const Edge& edge : forest) {
    indices[next[edge.i]++] = edge.j;
    indices[next[edge.j]++] = edge.i;
  }
  return {std::move(offsets), std::move(indices)};
}

}  // namespace

std::vector<Vec3> orient_normals(Points points, Normals normals, const Neighborhoods& neighborhoods,
                                 const Execution& execution) {
  require_size("normals", normals.size(), points.size());
  require_size("neighborhoods", neighborhoods.size(), points.size());
  std::vector<Edge> edges = neighbor_graph(normals, neighborhoods, execution);
  parallel_sort(edges, execution);
  const Neighborhoods forest = spanning_forest(points.size(), edges, execution);
  edges = {};
  check_cancelled(execution);

  // Highest points first: the first point of a piece that is met is its root.
  std::vector<std::uint32_t> roots(points.size());
  std::iota(roots.begin(), roots.end(), 0U);
  std::sort(roots.begin(), roots.end(), [&](std::uint32_t a, std::uint32_t b) {
    return points[a].z != points[b].z ? points[a].z > points[b].z : a < b;
  });
  std::vector<Vec3> oriented(normals.begin(), normals.end());
  std::vector<bool> seen(points.size());
  std::vector<std::uint32_t> open;
  for (const std::uint32_t root : roots) {
    if (seen[root]) continue;
    seen[root] = true;
    if (points_down(oriented[root])) oriented[root] = -oriented[root];
    open.push_back(root);
    while (!open.empty()) {
      const std::uint32_t parent = open.back();
      open.pop_back();
      for (const std::uint32_t child : forest[parent]) {
        if (seen[child]) continue;
        seen[child] = true;
        const double side = dot(oriented[child], oriented[parent]);
        if (side < 0 || (side == 0 && points_down(oriented[child]))) {
          oriented[child] = -oriented[child];
        }
        open.push_back(child);
      }
    }
  }
  return oriented;
}

}  // namespace deburr

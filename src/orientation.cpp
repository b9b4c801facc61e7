// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/orientation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

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
  std::vector<std::vector<Edge>> parts((normals.size() + block_size - 1) / block_size);
  parallel_blocks(
      normals.size(), without_progress(execution), [&](std::size_t begin, std::size_t end) {
        std::vector<Edge>& edges = parts[begin / block_size];
        for (std::size_t at = begin; at < end; ++at) {
          const auto i = static_cast<std::uint32_t>(at);
          if (is_zero(normals[i])) continue;
          for (const std::uint32_t j : neighborhoods[i]) {
            if (is_zero(normals[j])) continue;
            if (j < i && std::ranges::find(neighborhoods[j], i) != neighborhoods[j].end()) {
              continue;
            }
            edges.push_back(
                {1 - std::abs(dot(normals[i], normals[j])), std::min(i, j), std::max(i, j)});
          }
        }
      });
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  std::vector<Edge> edges;
  edges.reserve(count);
  for (auto& part : parts) {
    check_cancelled(execution);
    edges.insert(edges.end(), part.begin(), part.end());
    part = {};
  }
  return edges;
}

/// The minimum spanning forest, by Kruskal, without sorting edges within what lighter ones have
/// joined already (filter-Kruskal: Osipov, Sanders and Singler 2009). No two edges are equal, so
/// that there is one such forest.
class ForestFinder {
 public:
  ForestFinder(std::size_t n, const Execution& execution) : pieces_(n), watch_(execution) {}

  void add(std::span<Edge> edges) {
    if (edges.size() <= few) {
      std::sort(edges.begin(), edges.end());
      for (const Edge& edge : edges) {
        if (pieces_.join(edge.i, edge.j)) forest_.push_back(edge);
      }
      return;
    }
    const std::size_t half = edges.size() / 2;
    std::nth_element(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(half), edges.end(),
                     [&](const Edge& a, const Edge& b) {
                       watch_();
                       return a < b;
                     });
    add(edges.first(half));
    const auto heavy = edges.subspan(half);
    const auto end = std::remove_if(heavy.begin(), heavy.end(), [&](const Edge& edge) {
      watch_();
      return pieces_.find(edge.i) == pieces_.find(edge.j);
    });
    add(heavy.first(static_cast<std::size_t>(end - heavy.begin())));
  }

  [[nodiscard]] Pieces& pieces() { return pieces_; }
  [[nodiscard]] const std::vector<Edge>& forest() const { return forest_; }

 private:
  static constexpr std::size_t few = 4096;

  Pieces pieces_;
  std::vector<Edge> forest_;
  CancelWatch watch_;
};

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

/// The highest point of each piece, the first of those.
std::vector<std::uint32_t> highest_points(Points points, Pieces& pieces, CancelWatch& watch) {
  // A piece is known by its first point, which is met first.
  std::vector<std::uint32_t> highest(points.size());
  std::vector<std::uint32_t> firsts;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    watch();
    const std::uint32_t first = pieces.find(i);
    if (first == i) {
      firsts.push_back(i);
      highest[i] = i;
    } else if (points[i].z > points[highest[first]].z) {
      highest[first] = i;
    }
  }
  for (std::uint32_t& first : firsts) first = highest[first];
  return firsts;
}

}  // namespace

std::vector<Vec3> orient_normals(Points points, Normals normals, const Neighborhoods& neighborhoods,
                                 const Execution& execution) {
  require_size("normals", normals.size(), points.size());
  require_size("neighborhoods", neighborhoods.size(), points.size());
  std::vector<Edge> edges = neighbor_graph(normals, neighborhoods, execution);
  ForestFinder finder(points.size(), execution);
  finder.add(edges);
  edges = {};
  const Neighborhoods forest = adjacency(points.size(), finder.forest(), execution);

  std::vector<Vec3> oriented(normals.begin(), normals.end());
  std::vector<bool> seen(points.size());
  std::vector<std::uint32_t> open;
  CancelWatch watch(execution);
  for (const std::uint32_t root : highest_points(points, finder.pieces(), watch)) {
    seen[root] = true;
    if (points_down(oriented[root])) oriented[root] = -oriented[root];
    open.push_back(root);
    while (!open.empty()) {
      const std::uint32_t parent = open.back();
      open.pop_back();
      watch();
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

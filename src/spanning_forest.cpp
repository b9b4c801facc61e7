// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "spanning_forest.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "parallel.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Rounds in which every piece takes its lightest edge (Boruvka). Each leaves a fraction of the
/// pieces and of the edges between them, and needs no list of edges.
constexpr int rounds = 4;

/// Edges that are sorted without a look at the pieces.
constexpr std::size_t few = 4096;

constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

class ForestFinder {
 public:
  ForestFinder(Normals normals, const Neighborhoods& neighborhoods,
               std::span<const std::uint32_t> ids, Pieces& pieces, const Execution& execution)
      : normals_(normals),
        neighborhoods_(neighborhoods),
        ids_(ids),
        pieces_(pieces),
        execution_(execution),
        piece_(normals.size()) {
    forest_.reserve(normals.size());
  }

  std::vector<Edge> find() && {
    for (std::uint32_t i = 0; i < piece_.size(); ++i)
      piece_[i] = is_zero(normals_[i]) ? nothing : i;
    for (int round = 0; round < rounds; ++round) join_by_lightest();
    std::vector<Edge> rest = edges_between_pieces();
    add_in_order(rest);
    return std::move(forest_);
  }

 private:
  [[nodiscard]] bool lighter(const Edge& a, const Edge& b) const {
    if (a.weight != b.weight) return a.weight < b.weight;
    const auto ends = [&](const Edge& e) { return std::minmax(ids_[e.i], ids_[e.j]); };
    return std::pair<std::uint32_t, std::uint32_t>(ends(a)) <
           std::pair<std::uint32_t, std::uint32_t>(ends(b));
  }

  [[nodiscard]] Edge edge(std::uint32_t i, std::uint32_t j) const {
    return {1 - std::abs(dot(normals_[i], normals_[j])), i, j};
  }

  /// Calls visit(i) for the points that take part.
  template <typename Visit>
  void for_each_point(const Visit& visit) const {
    for (std::uint32_t i = 0; i < piece_.size(); ++i) {
      if (i % block_size == 0) check_cancelled(execution_);
      if (piece_[i] != nothing) visit(i);
    }
  }

  [[nodiscard]] bool is_between_pieces(std::uint32_t i, std::uint32_t j) const {
    return piece_[j] != piece_[i] && piece_[j] != nothing;
  }

  void join_by_lightest() {
    constexpr Edge none{std::numeric_limits<double>::infinity(), nothing, nothing};
    std::vector<Edge> lightest(piece_.size(), none);
    const auto offer = [&](const Edge& e, Edge& best) {
      if (e.weight < best.weight || (e.weight == best.weight && lighter(e, best))) best = e;
    };
    for_each_point([&](std::uint32_t i) {
      Edge own = lightest[piece_[i]];
      for (const std::uint32_t j : neighborhoods_[i]) {
        if (!is_between_pieces(i, j)) continue;
        const Edge e = edge(i, j);
        offer(e, own);
        offer(e, lightest[piece_[j]]);
      }
      lightest[piece_[i]] = own;
    });
    for (const Edge& e : lightest) {
      if (e.i != nothing && pieces_.join(e.i, e.j)) forest_.push_back(e);
    }
    for (std::uint32_t i = 0; i < piece_.size(); ++i) {
      if (piece_[i] != nothing) piece_[i] = pieces_.find(i);
    }
  }

  /// Each once.
  [[nodiscard]] std::vector<Edge> edges_between_pieces() const {
    std::vector<Edge> edges;
    for_each_point([&](std::uint32_t i) {
      for (const std::uint32_t j : neighborhoods_[i]) {
        if (!is_between_pieces(i, j)) continue;
        if (j < i && std::ranges::find(neighborhoods_[j], i) != neighborhoods_[j].end()) continue;
        edges.push_back(edge(i, j));
      }
    });
    return edges;
  }

  /// By Kruskal, without sorting edges within what lighter ones have joined already
  /// (filter-Kruskal: Osipov, Sanders and Singler 2009).
  void add_in_order(std::span<Edge> edges) {
    check_cancelled(execution_);
    const auto less = [&](const Edge& a, const Edge& b) { return lighter(a, b); };
    if (edges.size() <= few) {
      std::sort(edges.begin(), edges.end(), less);
      for (const Edge& e : edges) {
        if (pieces_.join(e.i, e.j)) forest_.push_back(e);
      }
      return;
    }
    const std::size_t half = edges.size() / 2;
    std::nth_element(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(half), edges.end(),
                     less);
    add_in_order(edges.first(half));
    const auto heavy = edges.subspan(half);
    const auto end = std::remove_if(heavy.begin(), heavy.end(), [&](const Edge& e) {
      return pieces_.find(e.i) == pieces_.find(e.j);
    });
    add_in_order(heavy.first(static_cast<std::size_t>(end - heavy.begin())));
  }

  Normals normals_;
  const Neighborhoods& neighborhoods_;
  std::span<const std::uint32_t> ids_;
  Pieces& pieces_;
  const Execution& execution_;
  std::vector<std::uint32_t> piece_;  ///< of each point, or nothing
  std::vector<Edge> forest_;
};

}  // namespace

std::vector<Edge> spanning_forest(Normals normals, const Neighborhoods& neighborhoods,
                                  std::span<const std::uint32_t> ids, Pieces& pieces,
                                  const Execution& execution) {
  return ForestFinder(normals, neighborhoods, ids, pieces, execution).find();
}

}  // namespace deburr

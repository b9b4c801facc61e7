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
constexpr Edge no_edge{std::numeric_limits<double>::infinity(), nothing, nothing};

/// Parts of the points that are looked through at once, at most: each needs an edge for every
/// point.
constexpr int most_parts = 4;

class ForestFinder {
 public:
  ForestFinder(Normals normals, const Neighborhoods& neighborhoods,
               std::span<const std::uint32_t> ids, JoinedSets& pieces, const Execution& execution)
      : normals_(normals),
        neighborhoods_(neighborhoods),
        ids_(ids),
        pieces_(pieces),
        quiet_(without_progress(execution)),
        piece_(normals.size()),
        lightest_(static_cast<std::size_t>(std::min(thread_count(execution), most_parts))) {
    forest_.reserve(normals.size());
  }

  std::vector<Edge> find() && {
    for (std::uint32_t i = 0; i < piece_.size(); ++i)
      piece_[i] = is_zero(normals_[i]) ? nothing : i;
    for (int round = 0; round < rounds; ++round) join_by_lightest();
    std::vector<Edge> rest = edges_between_pieces();
    release(lightest_);
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

  /// Calls visit(i) for the points in [begin, end) that take part.
  template <typename Visit>
  void for_each_point(std::uint32_t begin, std::uint32_t end, const Visit& visit) const {
    for (std::uint32_t i = begin; i < end; ++i) {
      if (i % block_size == 0) check_cancelled(quiet_);
      if (piece_[i] != nothing) visit(i);
    }
  }

  /// Calls visit(k, begin, end) for the parts of the points, [begin, end) being part k.
  template <typename Visit>
  void for_each_part(const Visit& visit) const {
    const std::size_t n = piece_.size();
    const std::size_t parts = lightest_.size();
    parallel_for<1>(parts, quiet_, [&](std::size_t k) {
      visit(k, static_cast<std::uint32_t>(k * n / parts),
            static_cast<std::uint32_t>((k + 1) * n / parts));
    });
  }

  [[nodiscard]] bool is_between_pieces(std::uint32_t i, std::uint32_t j) const {
    return piece_[j] != piece_[i] && piece_[j] != nothing;
  }

  void offer(const Edge& e, Edge& best) const {
    if (e.weight < best.weight || (e.weight == best.weight && lighter(e, best))) best = e;
  }

  /// Of each piece the lightest edge of those that points in [begin, end) have.
  void find_lightest(std::uint32_t begin, std::uint32_t end, std::vector<Edge>& lightest) const {
    lightest.assign(piece_.size(), no_edge);
    for_each_point(begin, end, [&](std::uint32_t i) {
      Edge own = lightest[piece_[i]];
      for (const std::uint32_t j : neighborhoods_[i]) {
        if (!is_between_pieces(i, j)) continue;
        const Edge e = edge(i, j);
        offer(e, own);
        offer(e, lightest[piece_[j]]);
      }
      lightest[piece_[i]] = own;
    });
  }

  void join_by_lightest() {
    // Which of all is the lightest does not depend on the parts.
    for_each_part([&](std::size_t k, std::uint32_t begin, std::uint32_t end) {
      find_lightest(begin, end, lightest_[k]);
    });
    const std::size_t n = piece_.size();
    parallel_for(n, quiet_, [&](std::size_t piece) {
      Edge& best = lightest_[0][piece];
      for (std::size_t k = 1; k < lightest_.size(); ++k) {
        const Edge& other = lightest_[k][piece];
        if (other.i != nothing) offer(other, best);
      }
    });
    for (const Edge& e : lightest_[0]) {
      if (e.i != nothing && pieces_.join(e.i, e.j)) forest_.push_back(e);
    }
    parallel_for(n, quiet_, [&](std::size_t i) {
      if (piece_[i] != nothing) piece_[i] = pieces_.find(static_cast<std::uint32_t>(i));
    });
  }

  /// Each once.
  [[nodiscard]] std::vector<Edge> edges_between_pieces() {
    // In the memory of what is no longer needed.
    for_each_part([&](std::size_t k, std::uint32_t begin, std::uint32_t end) {
      std::vector<Edge>& edges = lightest_[k];
      edges.clear();
      for_each_point(begin, end, [&](std::uint32_t i) {
        for (const std::uint32_t j : neighborhoods_[i]) {
          if (!is_between_pieces(i, j)) continue;
          if (j < i && std::ranges::find(neighborhoods_[j], i) != neighborhoods_[j].end()) continue;
          edges.push_back(edge(i, j));
        }
      });
    });
    for (std::size_t k = 1; k < lightest_.size(); ++k) {
      lightest_[0].insert(lightest_[0].end(), lightest_[k].begin(), lightest_[k].end());
    }
    return std::move(lightest_[0]);
  }

  /// By Kruskal, without sorting edges within what lighter ones have joined already
  /// (filter-Kruskal: Osipov, Sanders and Singler 2009).
  void add_in_order(std::span<Edge> edges) {
    check_cancelled(quiet_);
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
  JoinedSets& pieces_;
  Execution quiet_;
  std::vector<std::uint32_t> piece_;         ///< of each point, or nothing
  std::vector<std::vector<Edge>> lightest_;  ///< of each piece, as parts of the points have it
  std::vector<Edge> forest_;
};

}  // namespace

std::vector<Edge> spanning_forest(Normals normals, const Neighborhoods& neighborhoods,
                                  std::span<const std::uint32_t> ids, JoinedSets& pieces,
                                  const Execution& execution) {
  return ForestFinder(normals, neighborhoods, ids, pieces, execution).find();
}

}  // namespace deburr

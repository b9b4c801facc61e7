// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Union-find with path halving.
class Pieces {
 public:
  explicit Pieces(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Joins the pieces of i and j; false if they are one already. The smaller root stays one.
  bool join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
    return i != j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Two points next to each other; `weight` is small where their normals are nearly parallel.
struct Edge {
  double weight;
  std::uint32_t i, j;
};

/// The minimum spanning forest of the graph that joins every point with its neighbours, weighted
/// 1 - |n_i . n_j|. Points without a normal take no part: they could not pass a sign on.
/// @param ids  all different; edges of the same weight are ordered by the smaller of theirs, then
///             by the larger, so that there is one such forest
/// @param[out] pieces  of as many points, each its own before; joined as the forest joins them
std::vector<Edge> spanning_forest(Normals normals, const Neighborhoods& neighborhoods,
                                  std::span<const std::uint32_t> ids, Pieces& pieces,
                                  const Execution& execution);

}  // namespace deburr

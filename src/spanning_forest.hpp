// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/vec3.hpp"
#include "joined_sets.hpp"

namespace deburr {

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
                                  std::span<const std::uint32_t> ids, JoinedSets& pieces,
                                  const Execution& execution);

}  // namespace deburr

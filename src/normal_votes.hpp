// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "deburr/normal_filter.hpp"
#include "lanes.hpp"
#include "rows.hpp"

namespace deburr {

/// For each of up to eight points, the sum of n_j n_j^T over its voters, and their number.
struct Votes {
  LanesSym3 sum;
  Lanes count{};
};

/// Filters the normals of up to eight points by their votes; see filter_normals.
/// @param points  indices into normals
/// @param[out] filtered  gets them, in the order of the points
void turn_by_votes(const Votes& votes, std::span<const std::uint32_t> points, const Row* normals,
                   const NormalFilterOptions& options, Voteless voteless, std::span<Vec3> filtered);

}  // namespace deburr

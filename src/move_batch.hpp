// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "deburr/normal_filter.hpp"
#include "deburr/position_update.hpp"
#include "near_lists.hpp"
#include "neighbor_sums.hpp"
#include "point_class.hpp"

namespace deburr {

/// How points are classified and moved.
struct MoveOptions {
  const FeatureOptions& features;
  const PositionUpdateOptions& update;
  const NormalFilterOptions* filter;  ///< for the normals of the next round; null: not wanted
};

/// What becomes of up to eight points.
struct MovedBatch {
  PointClasses classes;
  std::array<Vec3, lane_count> places;
  std::array<Vec3, lane_count> normals;  ///< of the next round
};

/// Classifies up to eight points and tells where each of them goes. None sees the others move.
/// @param batch  the points, as indices into the cloud
/// @param near  near[l] are the neighbours of batch[l], likewise
/// @param original  where batch[l] was at first
/// @param upcoming  the lists of the next batch, whose rows are fetched from memory while this one
///                  is computed; null for none
void move_batch(std::span<const std::uint32_t> batch, const Oriented& cloud, const NearBatch& near,
                const std::array<Vec3, lane_count>& original, const MoveOptions& options,
                const NearBatch* upcoming, MovedBatch& to);

}  // namespace deburr

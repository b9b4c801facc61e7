// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "move_batch.hpp"

#include "normal_votes.hpp"
#include "point_move.hpp"

namespace deburr {
namespace {

/// Asks for the rows of a list, some of which are in memory only. They are more than the first
/// cache can hold.
void fetch(const Oriented& cloud, std::span<const std::uint32_t> list) {
  constexpr int for_reading = 0;
  constexpr int to_second_level = 2;
  for (const std::uint32_t j : list) {
    __builtin_prefetch(&cloud.points[j], for_reading, to_second_level);
    __builtin_prefetch(&cloud.normals[j], for_reading, to_second_level);
  }
}

}  // namespace

void move_batch(std::span<const std::uint32_t> batch, const Oriented& cloud, const NearBatch& near,
                const std::array<Vec3, lane_count>& original, const MoveOptions& options,
                const NearBatch* upcoming, MovedBatch& to) {
  Moments moments;
  SurfaceSums sums;
  Votes votes;
  for (std::size_t l = 0; l < batch.size(); ++l) {
    if (upcoming != nullptr) fetch(cloud, (*upcoming)[l]);
    if (options.filter != nullptr) {
      add_all(batch[l], cloud, near[l], options.features.rho, options.update, l, moments, sums,
              votes);
    } else {
      add_both(batch[l], cloud, near[l], options.features.rho, options.update, l, moments, sums);
    }
  }
  if (options.filter != nullptr) {
    turn_by_votes(votes, batch, cloud.normals, *options.filter, Voteless::Keep, to.normals);
  }
  classify_points(moments, options.features, to.classes);
  for (std::size_t l = 0; l < batch.size(); ++l) {
    to.places[l] =
        move_point(batch[l], original[l], cloud, to.classes[l], near[l], sums, l, options.update);
  }
}

}  // namespace deburr

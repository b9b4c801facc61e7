// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/execution.hpp"
#include "deburr/features.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Which normal the offset to a neighbour's plane is measured along.
enum class Offset {
  Projected,  ///< n_i: the published choice; shrinks curved surfaces
  Symmetric   ///< (n_i + n_j) / 2: exact on spheres, where the tangent planes' errors cancel
};

/// How the quadric of an edge or a corner is minimised.
enum class Quadric {
  Plain,   ///< unweighted, by the inverse; a singular matrix gives a meaningless place
  Guarded  ///< weighted by distance and regularised, so that it is never singular
};

/// What happens to a move beyond the bound.
enum class Bound {
  Reject,  ///< the point stays where it is in this round
  Clamp    ///< the point stops at the bound
};

/// Parameters of the position update. Lengths are in the unit of the points.
struct PositionUpdateOptions {
  double position_scale = 0;  ///< a in the weight exp(-|x_j-x_i|^2/a^2), > 0
  double normal_scale = 0.3;  ///< b in the weight exp(-|n_j-n_i|^2/b^2), > 0
  double step = 0.5;          ///< share of its offset that a surface point moves, in (0, 1]
  double feature_step = 0.5;  ///< share of its quadric's move that an edge or corner point moves
  double max_move = 0;        ///< largest distance from the original position, >= 0
  Offset offset = Offset::Symmetric;
  Quadric quadric = Quadric::Guarded;
  Bound bound = Bound::Clamp;
};

/// Moves every point by a quadric error with the constraint of its class, all at once: every sum
/// runs over `points`, the result is a new array.
///
/// - Surface: x_i + step t n_i with t = sum_j w_ij n . (x_j - x_i) / sum_j w_ij, where n is chosen
///   by `offset`.
/// - Edge along e: the point that fits the tangent planes of the neighbours best in the plane
///   across e.
/// - Corner: the point that fits the tangent planes best.
/// - Isolated points stay.
///
/// A point that would not be finite stays where it is.
///
/// Source: Yadav et al. 2018, restricted quadratic error metrics; differs where options say so.
/// @param original  positions before the first round, which max_move is measured from
/// @throws std::invalid_argument  if sizes differ or an option is out of its range
[[nodiscard]] std::vector<Vec3> update_positions(Points original, Points points, Normals normals,
                                                 const FeatureField& features,
                                                 const Neighborhoods& neighborhoods,
                                                 const PositionUpdateOptions& options,
                                                 const Execution& execution = {});

/// classify_features and update_positions in one pass over the neighbours, which is faster and
/// gives the same bits.
/// @param[in,out] points  the positions
/// @return the class of every point before it was moved
/// @throws std::invalid_argument  as classify_features and update_positions
FeatureField sweep_at_once(Points original, std::vector<Vec3>& points, Normals normals,
                           const Neighborhoods& neighborhoods, const FeatureOptions& features,
                           const PositionUpdateOptions& options, const Execution& execution = {});

/// The sweep of the authors' program: classifies and moves one point after the other, so that a
/// point sees the new positions of those before it. Runs on one thread.
/// @param[in,out] points  the positions
/// @param order  the indices of the points to move, in this order; empty for all, by index
/// @return the class of every point at the moment it was moved
/// @throws std::invalid_argument  as classify_features and update_positions
FeatureField sweep_in_place(Points original, std::vector<Vec3>& points, Normals normals,
                            const Neighborhoods& neighborhoods, const FeatureOptions& features,
                            const PositionUpdateOptions& options,
                            std::span<const std::uint32_t> order = {},
                            const Execution& execution = {});

}  // namespace deburr

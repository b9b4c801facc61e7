// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "deburr/execution.hpp"
#include "deburr/features.hpp"
#include "deburr/mesh.hpp"
#include "deburr/metrics.hpp"
#include "deburr/sharp_features.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Distances at which labels are judged, in mean spacings of the cloud (see mean_spacing).
inline constexpr double edge_reach = 1.5;        ///< an edge label is right up to here
inline constexpr double edge_point_reach = 0.5;  ///< points up to here are of the edge
inline constexpr double corner_reach = 2;        ///< a corner label is right up to here
inline constexpr double edge_zone = 1;           ///< what edge_error measures

/// How well labels match the true sharp edges and corners. Shares are in [0, 1], and NaN where
/// there is nothing to take a share of. A point is labelled if its label is Edge or Corner.
struct FeatureScore {
  double edge_precision = 0;  ///< of the labelled points, those within edge_reach of an edge
  double edge_recall = 0;     ///< of the length of the edges, what has a labelled point within
                              ///< edge_reach
  double edge_point_recall =
      0;  ///< of the points within edge_point_reach of an edge, those labelled
  double corner_precision = 0;  ///< of the points labelled Corner, those within corner_reach of one
  double corner_recall = 0;     ///< of the corners, those with a point labelled Corner within
                                ///< corner_reach
  std::size_t edge_labels = 0;  ///< points labelled Edge or Corner
  std::size_t corner_labels = 0;  ///< points labelled Corner
};

/// Judges labels by where the points are now. Points that are not finite are left out. The length
/// of the edges is looked at in pieces of at most a quarter of the spacing, each at its middle.
/// @param labels   one per point
/// @param spacing  mean spacing of the points, > 0, in their unit
/// @throws std::invalid_argument  if sizes differ, for a spacing out of its range, or for 2^32
///                                points or more
[[nodiscard]] FeatureScore score_features(Points points, std::span<const Feature> labels,
                                          const SharpFeatures& truth, double spacing,
                                          const Execution& execution = {});

/// Distances to the surface of the points within edge_zone of a sharp edge; as compare_to_surface
/// of these points alone.
/// @throws std::invalid_argument  as compare_to_surface, or for a spacing that is not > 0
[[nodiscard]] DistanceError edge_error(Points points, const TriangleMesh& surface,
                                       const SharpFeatures& sharp, double spacing,
                                       const Execution& execution = {});

}  // namespace deburr

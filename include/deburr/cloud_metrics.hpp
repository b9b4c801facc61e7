// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/execution.hpp"
#include "deburr/metrics.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Distance of every point to the nearest finite point of another cloud, in the unit of the input;
/// NaN for a point that is not finite, and everywhere where the other cloud has no finite point.
/// @throws std::invalid_argument  for a cloud of 2^32 points or more
[[nodiscard]] std::vector<double> distance_to_cloud(Points points, Points cloud,
                                                    const Execution& execution = {});

/// How two clouds differ, of which one is true.
struct CloudError {
  DistanceError to_truth;  ///< from the points to the nearest true ones
  DistanceError coverage;  ///< from the true points to the nearest ones of the cloud
  /// Chamfer distance: the mean squared distances of both directions, added, after the transform
  /// that takes the middle of the bounding box of the truth to 0 and its point farthest from there
  /// to distance 1, times 1e4; without unit. NaN where that is not defined: without finite points,
  /// or if all true ones are at one place.
  double chamfer = 0;
};

/// Compares points with the true cloud. Points that are not finite are left out. The distances grow
/// with the spacing of the truth, even for points that lie on the true surface: compare only
/// clouds that were measured against the same truth. Both diagonals are those of the truth.
///
/// Source of the Chamfer distance: the convention of point-cloud denoising benchmarks on PU-Net's
/// shapes, e.g. Luo and Hu, Score-Based Point Cloud Denoising, ICCV 2021.
/// @throws std::invalid_argument  for a cloud of 2^32 points or more
[[nodiscard]] CloudError compare_to_cloud(Points points, Points truth,
                                          const Execution& execution = {});

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Distances to something true, summarised. Lengths are in the unit of the input.
struct DistanceError {
  double mean = 0;           ///< mean distance
  double rms = 0;            ///< root of the mean squared distance
  double percentile_95 = 0;  ///< the smallest distance that 95 % of all do not exceed
  double maximum = 0;        ///< largest distance
  double diagonal = 0;       ///< of the bounding box of the truth, to make the above relative
  std::size_t count = 0;     ///< distances measured; where there are none, the first four are zero
};

/// The summary of distances to a surface.
using SurfaceError = DistanceError;

/// Distance of every point to the nearest point of the surface, exact up to rounding, >= 0, in the
/// unit of the input; NaN for a point that is not finite.
/// @throws std::invalid_argument  for a mesh without triangles, or with a corner that is no vertex
/// or
///                                not finite
[[nodiscard]] std::vector<double> distance_to_surface(Points points, const TriangleMesh& surface,
                                                      const Execution& execution = {});

/// How far points lie from the surface that they should lie on: summarises distance_to_surface over
/// all finite points.
/// @throws std::invalid_argument  as distance_to_surface
[[nodiscard]] SurfaceError compare_to_surface(Points points, const TriangleMesh& surface,
                                              const Execution& execution = {});

/// Where to look at how well points cover a surface.
struct CoverageOptions {
  std::size_t samples = 100000;  ///< places on the surface, uniform over its area; 0 for none
  std::uint64_t seed = 1;        ///< the same seed gives the same places
};

/// How far places of the surface lie from the nearest finite point: large where points have left a
/// part of the surface bare. Points that lie exactly on the surface and evenly on it, at a mean
/// spacing s, give a mean of 0.38 s (square grid) to 0.5 s (uniformly random).
///
/// Without a finite point, or for a surface without area, nothing is measured: the count is zero.
/// @throws std::invalid_argument  as distance_to_surface, or for 2^32 points or more
[[nodiscard]] DistanceError surface_coverage(Points points, const TriangleMesh& surface,
                                             const CoverageOptions& options = {},
                                             const Execution& execution = {});

/// Mean spacing of `count` points on a surface: sqrt(area / count), in the unit of the input; the
/// unit in which the search for features is judged. Zero where there are no points.
/// @throws std::invalid_argument  as distance_to_surface
[[nodiscard]] double mean_spacing(const TriangleMesh& surface, std::size_t count);

}  // namespace deburr

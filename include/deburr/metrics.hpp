// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Distance of every point to the nearest point of the surface, exact up to rounding, >= 0, in the
/// unit of the input; NaN for a point that is not finite.
/// @throws std::invalid_argument  for a mesh without triangles, or with a corner that is no vertex
/// or
///                                not finite
[[nodiscard]] std::vector<double> distance_to_surface(Points points, const TriangleMesh& surface,
                                                      const Execution& execution = {});

/// How far points lie from the surface that they should lie on.
struct SurfaceError {
  double mean = 0;        ///< mean distance, in the unit of the input
  double rms = 0;         ///< root of the mean squared distance
  double maximum = 0;     ///< largest distance
  double diagonal = 0;    ///< of the bounding box of the surface, to make the above relative
  std::size_t count = 0;  ///< points measured: those that are finite
};

/// Summarises distance_to_surface over all finite points; where there is none, all but the diagonal
/// are zero.
/// @throws std::invalid_argument  as distance_to_surface
[[nodiscard]] SurfaceError compare_to_surface(Points points, const TriangleMesh& surface,
                                              const Execution& execution = {});

}  // namespace deburr

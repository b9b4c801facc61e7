// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "deburr/execution.hpp"
#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Angles between normals and the true ones, in degrees.
struct NormalError {
  double unoriented = 0;  ///< mean angle between the lines, 0 to 90
  double oriented = 0;    ///< mean angle between the directions, 0 to 180
  std::size_t count = 0;  ///< normals measured; where there are none, the angles are zero
};

/// Compares the normal of every point with that of the nearest triangle.
///
/// A triangle's normal is that of its corners in their order (right hand), which points outwards if
/// the mesh says so. The oriented error takes the normals as they are: a cloud whose normals all
/// point inwards is 180 degrees minus its error away. Of several triangles at the same distance, to
/// rounding, as at edges and vertices, the one counts that agrees best; this is decided for both
/// angles separately. Left out are points that are not finite, normals that are zero or not finite
/// (their length is of no matter), and points with no triangle nearest to them that has an area.
/// @param points   positions
/// @param normals  one per point
/// @throws std::invalid_argument  if sizes differ, or for a mesh that distance_to_surface refuses
[[nodiscard]] NormalError normal_error(Points points, Normals normals, const TriangleMesh& surface,
                                       const Execution& execution = {});

/// Compares the normal of every point with that of the nearest point of a true cloud; of several at
/// the same distance, to rounding, with that which agrees best. Points of the true cloud that are
/// not finite, and its normals that are zero or not finite, are left out.
/// @throws std::invalid_argument  if sizes differ, or for 2^32 points or more
[[nodiscard]] NormalError normal_error(Points points, Normals normals, Points truth,
                                       Normals true_normals, const Execution& execution = {});

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Faces that meet at more than this are sharp, and sharp edges that turn by more form a corner; in
/// degrees. Rounded shapes that were triangulated finely stay below it.
inline constexpr double sharp_angle = 30;

/// Where a surface is sharp.
struct SharpFeatures {
  std::vector<std::array<Vec3, 2>> edges;  ///< both ends of each
  std::vector<Vec3> corners;
};

/// Finds the sharp edges and corners of a mesh.
///
/// Vertices at the same place count as one, and triangles with the same corners, too. An edge is
/// sharp where the normals of two of its triangles differ by more than sharp_angle, both seen from
/// the same side, whichever way the corners of either run. A border of the surface is not sharp.
/// A corner is where three or more sharp edges meet, or two that turn by more than sharp_angle.
/// Triangles without area are left out, so that an edge that only they connect is a border.
/// Angles of exactly sharp_angle do not count, with 1e-6 of the cosine left for rounding.
/// @throws std::invalid_argument  for a mesh that distance_to_surface refuses
[[nodiscard]] SharpFeatures find_sharp_features(const TriangleMesh& surface);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "view/fields.hpp"
#include "view/up.hpp"

namespace deburr::view {

/// Where a picture is taken from: from the front of the frame of Up, from its back and so on.
enum class View { Iso, Front, Back, Left, Right, Top, Bottom };

/// A view without perspective.
struct Camera {
  Vec3 centre;  ///< in the middle of the picture
  Vec3 right;   ///< these three are of length 1 and at right angles
  Vec3 up;
  Vec3 towards;      ///< from the centre to the viewer
  double scale = 1;  ///< pixels per unit

  /// Shows nearly all of the finite points; a few that lie far off may be outside.
  static Camera fit(View view, Points points, int width, int height, Up up = Up::Z);
};

/// Points as discs on their surface.
struct Splats {
  Points points;                 ///< those that are not finite are left out
  Normals normals;               ///< of any length; a point without one faces the viewer
  std::span<const Rgb> colours;  ///< one per point
  double radius = 0;             ///< input units, > 0
};

struct RasterOptions {
  int width = 1200;    ///< in [1, 16384]
  int height = 900;    ///< in [1, 16384]
  int samples = 3;     ///< per pixel along each side, in [1, 8]
  double light = 0.7;  ///< how much of the brightness depends on the normal, in [0, 1]
  Rgb background{255, 255, 255};
};

/// Rows from the top, three bytes per pixel.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Draws points with a depth buffer, on one thread and always the same. Of points at one depth the
/// first is seen. Light falls from beside the viewer, on both sides of a surface.
/// @param execution  says when to stop
/// @throws std::invalid_argument  for spans of other lengths, or an option out of its range
/// @throws Cancelled  when execution.cancelled says so
[[nodiscard]] Picture draw(const Splats& splats, const Camera& camera,
                           const RasterOptions& options = {}, const Execution& execution = {});

}  // namespace deburr::view

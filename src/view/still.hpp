// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deburr/execution.hpp"
#include "view/raster.hpp"
#include "view/scene.hpp"

namespace deburr::view {

/// What a still picture shows by its colours.
enum class StillColour { Normals, Displacement, Labels, OfFile };

struct StillOptions {
  StillColour colour = StillColour::Normals;
  View view = View::Iso;
  Up up = Up::Z;  ///< the views are taken with this axis up
  /// Displacement of the last colour, input units, >= 0; 0 for the one that 98 % do not exceed.
  double range = 0;
  bool legend = true;                  ///< say below what displacement and labels are coloured by
  RasterOptions raster{};              ///< of the whole picture, with its legend
  std::size_t max_points = 2'000'000;  ///< more, and they are drawn spread evenly
  std::size_t neighbors = 12;          ///< for the spacing, and for normals where there are none
};

struct StillPicture {
  Picture picture;
  std::size_t points = 0;  ///< drawn
  bool is_signed = false;  ///< whether the displacement is along the normals
  double range = 0;        ///< of the colours of the displacement
  bool legend = false;     ///< whether there is one; a small picture has no room for it
};

/// Draws the last cloud of a request as points on a surface, without a graphics card. The
/// displacement is that of make_scene.
/// @throws DataError  where the cloud has not what the colours should show, or no finite point
/// @throws std::invalid_argument  as make_scene and draw
[[nodiscard]] StillPicture draw_still(const Request& request, const StillOptions& options = {},
                                      const Execution& execution = {});

}  // namespace deburr::view

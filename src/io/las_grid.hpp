// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "deburr/vec3.hpp"
#include "io/las_header.hpp"

namespace deburr {

/// A grid for coordinates, and what it does to them.
struct GridChoice {
  LasGrid grid;
  bool is_exact = true;         ///< every coordinate is read back as the same double
  bool is_coarse = false;       ///< coarser than wished, for want of integers
  std::array<double, 3> low{};  ///< bounding box of what is read back
  std::array<double, 3> high{};
};

/// Refines the grid of a file until its steps are no larger than `resolution`, if that is > 0. A
/// step is halved again and again: so the old places keep their doubles to the last bit.
/// @return none if a point lies outside of what the grid reaches
[[nodiscard]] std::optional<GridChoice> refine_grid(const LasGrid& old, Points points,
                                                    double resolution);

/// The finest grid of powers of ten for finite points; the unit of length plays no role.
/// @return none where doubles are too few for any grid
[[nodiscard]] std::optional<GridChoice> choose_grid(Points points);

}  // namespace deburr

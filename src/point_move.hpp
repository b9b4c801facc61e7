// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "deburr/position_update.hpp"
#include "neighbor_sums.hpp"
#include "point_class.hpp"

namespace deburr {

/// Where point i goes; see update_positions.
/// @param sums  of which lane `l` is of this point, if it is on a surface
Vec3 move_point(std::size_t i, const Vec3& original, const Oriented& cloud,
                const PointClass& point_class, std::span<const std::uint32_t> neighbors,
                const SurfaceSums& sums, std::size_t l, const PositionUpdateOptions& options);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "deburr/position_update.hpp"
#include "point_class.hpp"

namespace deburr {

/// The new position of point i; see update_positions.
Vec3 move_point(std::size_t i, const Vec3& original, Points points, Normals normals,
                const PointClass& point_class, std::span<const std::uint32_t> neighbors,
                const PositionUpdateOptions& options);

}  // namespace deburr

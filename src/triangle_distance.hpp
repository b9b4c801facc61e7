// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "deburr/vec3.hpp"

namespace deburr {

using Triangle = std::array<Vec3, 3>;

/// Squared distance from a point to the nearest point of a triangle. A triangle without area is the
/// segment or the point that its corners span.
///
/// Only differences of coordinates enter, so an offset common to all costs nothing. The distance is
/// always measured to a point of the triangle; for thin triangles, too, it is off by no more than a
/// few roundings of the length of the triangle or of the distance, whichever is larger.
[[nodiscard]] double squared_distance(const Vec3& p, const Triangle& triangle);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "box.hpp"
#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"
#include "random.hpp"

namespace deburr {

/// Where outliers may lie: a box of twice the extent about the same centre. A flat box is first
/// made a tenth of its diagonal thick, so that outliers of a plate are off the plate.
[[nodiscard]] Box outlier_box(const Box& box);

/// `count` points, uniform in a box.
[[nodiscard]] std::vector<Vec3> scattered_outliers(std::size_t count, const Box& box,
                                                   Random& random);

/// `count` points in balls of 15 to 60 points each, uniform within a ball; fewer than 15 where
/// `count` is less.
/// @param radius     of the balls, > 0
/// @param clearance  smallest distance of their centres from the surface
/// @throws DataError  if no place in the box is that far off, or too few are for one to be found
[[nodiscard]] std::vector<Vec3> clustered_outliers(std::size_t count, double radius,
                                                   double clearance, const TriangleMesh& surface,
                                                   const Box& box, Random& random);

}  // namespace deburr

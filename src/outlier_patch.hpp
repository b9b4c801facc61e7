// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "deburr/vec3.hpp"

namespace deburr {

/// A piece of surface: a height above a plane that is quadratic in the place on it.
struct Patch {
  Vec3 center;                     ///< origin of u, v and the height
  Vec3 u, v, normal;               ///< orthonormal
  std::array<double, 6> height{};  ///< of 1, u, v, u^2, u v, v^2, with lengths over radius
  double radius = 0;               ///< distance of the farthest point fitted, > 0
  double spread = 0;               ///< of the points around the patch, as a standard deviation
  double flatness = 0;  ///< thickness over width of the points fitted: about 1 for a ball
};

/// Where a point is beside a patch.
struct Foot {
  Vec3 at;              ///< on the patch, straight below the point
  double distance = 0;  ///< from the patch, to first order
  double aside = 0;     ///< from the centre, along the plane
};

/// Fits a patch to points, robustly: points far off count less with each round, and those
/// beyond three times the scale of the residuals not at all.
/// @param points  at least 8, within a box of 4; all at one place gives a level patch
[[nodiscard]] Patch fit_patch(std::span<const Vec3> points, const Vec3& around);

[[nodiscard]] Foot foot_on(const Patch& patch, const Vec3& point);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "sym3.hpp"

namespace deburr {

/// Where three planes dot(n, x) = d with unit normals meet; nothing where they are too nearly of
/// one direction for that place to be known.
inline std::optional<Vec3> three_planes_meet(const Vec3& n1, double d1, const Vec3& n2, double d2,
                                             const Vec3& n3, double d3) {
  constexpr double least_determinant = 0.1;
  Eigen::Matrix3d m;
  m << to_eigen(n1).transpose(), to_eigen(n2).transpose(), to_eigen(n3).transpose();
  if (std::abs(m.determinant()) < least_determinant) return std::nullopt;
  return to_vec3(m.inverse() * Eigen::Vector3d(d1, d2, d3));
}

}  // namespace deburr

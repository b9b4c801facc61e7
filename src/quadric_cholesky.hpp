// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "deburr/vec3.hpp"
#include "sym3.hpp"

namespace deburr {

/// Cholesky's decomposition L D L^T of a positive semidefinite 3x3 matrix. A row that depends on
/// those before it, so that nothing is left for its pivot, is left out: its solution is 0.
class Cholesky3 {
 public:
  explicit Cholesky3(const Sym3& m) {
    inverse_.x = inverse_of(m.xx);
    yx_ = m.xy * inverse_.x;
    zx_ = m.xz * inverse_.x;
    inverse_.y = inverse_of(m.yy - yx_ * m.xy);
    const double rest = m.yz - zx_ * m.xy;
    zy_ = rest * inverse_.y;
    inverse_.z = inverse_of(m.zz - zx_ * m.xz - zy_ * rest);
  }

  /// L^-1 v
  [[nodiscard]] Vec3 forward(const Vec3& v) const {
    const double y = v.y - yx_ * v.x;
    return {v.x, y, v.z - zx_ * v.x - zy_ * y};
  }
  /// D^-1 v
  [[nodiscard]] Vec3 divided(const Vec3& v) const {
    return {v.x * inverse_.x, v.y * inverse_.y, v.z * inverse_.z};
  }
  /// L^-T v
  [[nodiscard]] Vec3 backward(const Vec3& v) const {
    const double y = v.y - zy_ * v.z;
    return {v.x - yx_ * y - zx_ * v.z, y, v.z};
  }

 private:
  static double inverse_of(double pivot) { return pivot > 0 ? 1 / pivot : 0; }

  double yx_, zx_, zy_;  ///< of L
  Vec3 inverse_;         ///< of D
};

/// Cholesky's decomposition of the normal equations of a quadric, in blocks: that of the plane,
/// whose terms come first, and that of what the plane leaves of the quadratic terms.
class QuadricCholesky {
 public:
  using Moments = std::array<double, 15>;  ///< products of two terms, as in WeightedQuadric::Sums
  using Row = std::array<double, 6>;       ///< of the terms 1, x, y, x^2, xy, y^2

  /// @param ridge  what is added to the diagonal: of the first three terms, of the others
  QuadricCholesky(const Moments& m, const std::array<double, 2>& ridge)
      : plane_({m[0] + ridge[0], m[1], m[2], m[3] + ridge[0], m[4], m[5] + ridge[0]}),
        mixed_{plane_.forward({m[3], m[6], m[7]}), plane_.forward({m[4], m[7], m[8]}),
               plane_.forward({m[5], m[8], m[9]})},
        below_{plane_.divided(mixed_[0]), plane_.divided(mixed_[1]), plane_.divided(mixed_[2])},
        rest_({m[10] - dot(below_[0], mixed_[0]) + ridge[1], m[11] - dot(below_[0], mixed_[1]),
               m[12] - dot(below_[0], mixed_[2]), m[12] - dot(below_[1], mixed_[1]) + ridge[1],
               m[13] - dot(below_[1], mixed_[2]), m[14] - dot(below_[2], mixed_[2]) + ridge[1]}) {}

  /// A right side on the way to its solution.
  struct Half {
    Vec3 plane, rest;
    double plane_form, rest_form;  ///< the product of right side and solution: of the plane alone,
                                   ///< and what the quadratic terms add to it
  };
  [[nodiscard]] Half forward(const Row& right) const {
    const Vec3 plane = plane_.forward({right[0], right[1], right[2]});
    const Vec3 rest =
        rest_.forward({right[3] - dot(below_[0], plane), right[4] - dot(below_[1], plane),
                       right[5] - dot(below_[2], plane)});
    Half half{plane_.divided(plane), rest_.divided(rest), 0, 0};
    half.plane_form = dot(half.plane, plane);
    half.rest_form = dot(half.rest, rest);
    return half;
  }

  /// The solution among planes.
  [[nodiscard]] Row plane(const Half& half) const {
    const Vec3 c = plane_.backward(half.plane);
    return {c.x, c.y, c.z, 0, 0, 0};
  }
  /// The solution.
  [[nodiscard]] Row quadric(const Half& half) const {
    const Vec3 q = rest_.backward(half.rest);
    const Vec3 c =
        plane_.backward(half.plane - q.x * below_[0] - q.y * below_[1] - q.z * below_[2]);
    return {c.x, c.y, c.z, q.x, q.y, q.z};
  }

 private:
  Cholesky3 plane_;
  std::array<Vec3, 3> mixed_;  ///< L D of the lower left block, a row for each quadratic term
  std::array<Vec3, 3> below_;  ///< L there
  Cholesky3 rest_;
};

}  // namespace deburr

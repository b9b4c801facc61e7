// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>

#include "deburr/vec3.hpp"

namespace deburr {

/// A symmetric 3 x 3 matrix that is a sum of outer products.
struct Sym3 {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  /// Adds weight * v v^T.
  void add_outer(double weight, const Vec3& v) {
    const Vec3 w = weight * v;
    xx += w.x * v.x;
    xy += w.x * v.y;
    xz += w.x * v.z;
    yy += w.y * v.y;
    yz += w.y * v.z;
    zz += w.z * v.z;
  }
  void scale(double s) {
    for (double* const e : {&xx, &xy, &xz, &yy, &yz, &zz}) *e *= s;
  }
  [[nodiscard]] double trace() const { return xx + yy + zz; }
  [[nodiscard]] Eigen::Matrix3d matrix() const {
    return Eigen::Matrix3d{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
  }
  friend Vec3 operator*(const Sym3& m, const Vec3& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
            m.xz * v.x + m.yz * v.y + m.zz * v.z};
  }
};

inline Vec3 to_vec3(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Eigen::Vector3d to_eigen(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Eigenvalues in descending order with their unit eigenvectors.
struct Spectrum {
  std::array<double, 3> values;
  std::array<Vec3, 3> vectors;
};

// How the decomposition goes, in one matrix as in eight at a time.
namespace jacobi {

/// Each rotation squares what is left off the diagonal, so that few sweeps are ever needed.
inline constexpr int most_sweeps = 20;

/// Off-diagonal entries below this share of the trace no longer turn the eigenvectors.
inline constexpr double negligible = 1e-20;

/// The first sweeps leave entries alone that are small beside the sum of all (Rutishauser 1966).
inline constexpr int coarse_sweeps = 3;
inline constexpr double coarse_share = 0.2 / 9;

}  // namespace jacobi

/// Decomposes by cyclic Jacobi rotations until the off-diagonal entries sum to no more than
/// `tolerance`, or to nothing beside the trace. The QR iteration of Eigen is not accurate enough
/// here: to 1e-11 only where two eigenvalues are close.
Spectrum spectrum(const Sym3& m, double tolerance = 0);

}  // namespace deburr

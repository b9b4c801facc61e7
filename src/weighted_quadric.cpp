// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "weighted_quadric.hpp"

#include <algorithm>
#include <cstdint>

namespace deburr {
namespace {

/// Fewer samples do not determine a quadric well.
constexpr std::size_t fewest_for_quadric = 9;

/// Shares of the total weight that are added to the diagonals: samples on a line, or all at one
/// distance, must not make a slope or a curvature out of rounding.
constexpr double plane_ridge = 1e-9;
constexpr double quadric_ridge = 1e-6;

using Matrix6 = WeightedQuadric::Matrix6;
using Vector6 = WeightedQuadric::Vector6;

/// Where the product of two terms stands among the moments.
constexpr std::array<std::array<std::uint8_t, 6>, 6> product{{{0, 1, 2, 3, 4, 5},
                                                              {1, 3, 4, 6, 7, 8},
                                                              {2, 4, 5, 7, 8, 9},
                                                              {3, 6, 7, 10, 11, 12},
                                                              {4, 7, 8, 11, 12, 13},
                                                              {5, 8, 9, 12, 13, 14}}};

Matrix6 matrix_of(const std::array<double, WeightedQuadric::moments>& sums) {
  Matrix6 m;
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t c = 0; c < 6; ++c) {
      m(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = sums[product[r][c]];
    }
  }
  return m;
}

}  // namespace

WeightedQuadric::Solution WeightedQuadric::finish(double squares, double parameters) const {
  Solution s;
  s.freedom = std::max(1.0, sums_.shares * sums_.shares / sums_.share_squares - parameters);
  s.residual = std::max(0.0, squares) * sums_.normal[0] / sums_.spread[0] / s.freedom;
  return s;
}

WeightedQuadric::Both WeightedQuadric::solve() const {
  Both both;
  const double total = sums_.normal[0];
  const Matrix6 normal = matrix_of(sums_.normal);
  const Matrix6 spread = matrix_of(sums_.spread);
  const Vector6 right = Eigen::Map<const Vector6>(sums_.right.data());
  Eigen::Matrix3d plane = normal.topLeftCorner<3, 3>();
  plane.diagonal().array() += plane_ridge * total;
  const Eigen::LDLT<Eigen::Matrix3d> by_plane(plane);
  const Eigen::Vector3d flat = by_plane.solve(right.head<3>());
  const double plane_squares = sums_.heights - flat.dot(right.head<3>());
  both.plane = finish(plane_squares, 3);
  both.plane.surface.c = {flat(0), flat(1) / scale_, flat(2) / scale_, 0, 0, 0};
  const Eigen::Vector3d plane_pull = by_plane.solve(Eigen::Vector3d::Unit(0));
  both.plane.variance = plane_pull.dot(spread.topLeftCorner<3, 3>() * plane_pull);
  both.quadric = both.plane;
  if (sums_.count < fewest_for_quadric) return both;

  Matrix6 quadric = normal;
  quadric.diagonal().tail<3>().array() += quadric_ridge * total;
  const Eigen::LDLT<Matrix6> by_quadric(quadric);
  const Vector6 c = by_quadric.solve(right);
  const double quadric_squares = sums_.heights - c.dot(right);
  both.quadric = finish(quadric_squares, 6);
  const double per_square = 1 / (scale_ * scale_);
  both.quadric.surface.c = {
      c(0), c(1) / scale_, c(2) / scale_, c(3) * per_square, c(4) * per_square, c(5) * per_square};
  const Vector6 pull = by_quadric.solve(Vector6::Unit(0));
  both.quadric.variance = pull.dot(spread * pull);
  both.curvature = (plane_squares - quadric_squares) / (3 * sums_.spread[0] / total);
  return both;
}

}  // namespace deburr

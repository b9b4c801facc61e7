// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "weighted_quadric.hpp"

#include <algorithm>

namespace deburr {
namespace {

/// Fewer samples do not determine a quadric well.
constexpr std::size_t fewest_for_quadric = 9;

/// Shares of the total weight that are added to the diagonals: samples on a line, or all at one
/// distance, must not make a slope or a curvature out of rounding.
constexpr double plane_ridge = 1e-9;
constexpr double quadric_ridge = 1e-6;

}  // namespace

WeightedQuadric::Solution WeightedQuadric::finish(double squares, double parameters) const {
  Solution s;
  s.freedom = std::max(1.0, shares_ * shares_ / share_squares_ - parameters);
  s.residual = std::max(0.0, squares) * total_ / squares_ / s.freedom;
  return s;
}

WeightedQuadric::Both WeightedQuadric::solve() const {
  using Eigen::Lower;
  Both both;
  Eigen::Matrix3d plane = normal_.topLeftCorner<3, 3>().selfadjointView<Lower>();
  plane.diagonal().array() += plane_ridge * total_;
  const Eigen::LDLT<Eigen::Matrix3d> by_plane(plane);
  const Eigen::Vector3d flat = by_plane.solve(right_.head<3>());
  const double plane_squares = heights_ - flat.dot(right_.head<3>());
  both.plane = finish(plane_squares, 3);
  both.plane.surface.c = {flat(0), flat(1) / scale_, flat(2) / scale_, 0, 0, 0};
  const Eigen::Vector3d plane_pull = by_plane.solve(Eigen::Vector3d::Unit(0));
  both.plane.variance =
      plane_pull.dot(spread_.topLeftCorner<3, 3>().selfadjointView<Lower>() * plane_pull);
  both.quadric = both.plane;
  if (count_ < fewest_for_quadric) return both;

  Matrix6 quadric = normal_.selfadjointView<Lower>();
  quadric.diagonal().tail<3>().array() += quadric_ridge * total_;
  const Eigen::LDLT<Matrix6> by_quadric(quadric);
  const Vector6 c = by_quadric.solve(right_);
  const double quadric_squares = heights_ - c.dot(right_);
  both.quadric = finish(quadric_squares, 6);
  const double per_square = 1 / (scale_ * scale_);
  both.quadric.surface.c = {
      c(0), c(1) / scale_, c(2) / scale_, c(3) * per_square, c(4) * per_square, c(5) * per_square};
  const Vector6 pull = by_quadric.solve(Vector6::Unit(0));
  both.quadric.variance = pull.dot(spread_.selfadjointView<Lower>() * pull);
  both.curvature = (plane_squares - quadric_squares) / (3 * squares_ / total_);
  return both;
}

}  // namespace deburr

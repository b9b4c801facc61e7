// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "quadric_fit.hpp"

namespace deburr {

/// Sums for a weighted fit of a height over a plane, as a plane and as a quadric.
///
/// Sample k has weight w_k, of which m_k is the number of points that it is the mean of: the
/// variance of its height is sigma^2 / m_k.
class WeightedQuadric {
 public:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;

  /// @param scale  coordinates are divided by it, so that all sums are of one order
  explicit WeightedQuadric(double scale) : scale_(scale) {}

  void add(double x, double y, double height, double weight, double points) {
    x /= scale_;
    y /= scale_;
    const Vector6 terms{1, x, y, x * x, x * y, y * y};
    const Vector6 weighted = weight * terms;
    const double share = weight / points;
    for (int c = 0; c < 6; ++c) {
      normal_.col(c).tail(6 - c) += terms(c) * weighted.tail(6 - c);
      spread_.col(c).tail(6 - c) += share * terms(c) * weighted.tail(6 - c);
    }
    right_ += height * weighted;
    heights_ += weight * height * height;
    total_ += weight;
    squares_ += weight * share;
    shares_ += share;
    share_squares_ += share * share;
    ++count_;
  }

  struct Solution {
    HeightQuadric surface;
    double residual = 0;  ///< estimated variance of the height of a single point about the surface
    double freedom = 0;   ///< degrees of freedom of that
    double variance = 0;  ///< of the height at the origin, for points of variance 1
  };
  struct Both {
    Solution plane;
    Solution quadric;      ///< a plane again where there are too few samples
    double curvature = 0;  ///< what the quadratic terms take off the squares, over what noise of
                           ///< variance 1 lets them take off
  };

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] Both solve() const;

 private:
  [[nodiscard]] Solution finish(double squares, double parameters) const;

  double scale_;
  Matrix6 normal_ = Matrix6::Zero();  ///< lower triangles
  Matrix6 spread_ = Matrix6::Zero();
  Vector6 right_ = Vector6::Zero();
  double heights_ = 0, total_ = 0, squares_ = 0, shares_ = 0, share_squares_ = 0;
  std::size_t count_ = 0;
};

}  // namespace deburr

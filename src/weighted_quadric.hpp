// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <array>
#include <cstddef>

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

  static constexpr std::size_t terms = 6;     ///< 1, x, y, x^2, xy, y^2
  static constexpr std::size_t moments = 15;  ///< products of two of them, up to y^4

  /// Sums over samples.
  struct Sums {
    std::array<double, moments> normal{};  ///< of weights times products: 1, x, y, x^2, xy, y^2,
                                           ///< x^3, x^2 y, x y^2, y^3, x^4, x^3 y, ..., y^4
    std::array<double, moments> spread{};  ///< of w_k^2 / m_k times these
    std::array<double, terms> right{};     ///< of weights times height times terms
    double heights = 0;                    ///< of weights times squared height
    double shares = 0;                     ///< of w_k / m_k
    double share_squares = 0;              ///< of their squares
    std::size_t count = 0;                 ///< of samples with a weight
  };

  /// @param scale  coordinates are divided by it, so that all sums are of one order
  explicit WeightedQuadric(double scale) : scale_(scale) {}

  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] Sums& sums() { return sums_; }

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

  [[nodiscard]] std::size_t count() const { return sums_.count; }
  [[nodiscard]] Both solve() const;

 private:
  [[nodiscard]] Solution finish(double squares, double parameters) const;

  double scale_;
  Sums sums_;
};

}  // namespace deburr

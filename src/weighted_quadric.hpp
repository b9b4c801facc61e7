// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "quadric_cholesky.hpp"
#include "quadric_fit.hpp"

namespace deburr {

/// Sums for a weighted fit of a height over a plane, as a plane and as a quadric.
///
/// Sample k has weight w_k, of which m_k is the number of points that it is the mean of: the
/// variance of its height is sigma^2 / m_k.
class WeightedQuadric {
 public:
  static constexpr std::size_t terms = 6;     ///< 1, x, y, x^2, xy, y^2
  static constexpr std::size_t moments = 15;  ///< products of two of them, up to y^4

  /// Sums over samples.
  struct Sums {
    std::array<double, moments> normal{};  ///< of weights times products: 1, x, y, x^2, xy, y^2,
                                           ///< x^3, x^2 y, x y^2, y^3, x^4, x^3 y, ..., y^4
    std::array<double, terms> right{};     ///< of weights times height times terms
    double heights = 0;                    ///< of weights times squared height
    double spread = 0;                     ///< of w_k^2 / m_k
    double shares = 0;                     ///< of w_k / m_k
    double share_squares = 0;              ///< of their squares
    std::size_t count = 0;                 ///< of samples with a weight
  };

  /// @param scale  coordinates are divided by it, so that all sums are of one order
  explicit WeightedQuadric(double scale) : scale_(scale) {}

  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] Sums& sums() { return sums_; }
  [[nodiscard]] std::size_t count() const { return sums_.count; }

  struct Solution {
    HeightQuadric surface;
    double residual = 0;  ///< estimated variance of the height of a single point about the surface
    double freedom = 0;   ///< degrees of freedom of that
    /// The height at the origin is a sum over the samples, of weight times height times this
    /// quadric: for points of variance 1, its variance is that of w_k^2 / m_k times its square.
    HeightQuadric pull;
  };

  /// What solves the sums, which have to live as long.
  class Solver {
   public:
    [[nodiscard]] Solution plane() const;
    /// A plane again where there are too few samples.
    [[nodiscard]] Solution quadric() const;
    /// What the quadratic terms take off the squares, over what noise of variance 1 lets them
    /// take off.
    [[nodiscard]] double curvature() const;

   private:
    friend class WeightedQuadric;
    explicit Solver(const WeightedQuadric& of);
    [[nodiscard]] Solution finish(const QuadricCholesky::Row& c, const QuadricCholesky::Row& pull,
                                  double squares, double parameters) const;

    const WeightedQuadric& of_;
    QuadricCholesky normal_;
    QuadricCholesky::Half heights_;
  };
  [[nodiscard]] Solver solve() const { return Solver(*this); }

 private:
  double scale_;
  Sums sums_;
};

}  // namespace deburr

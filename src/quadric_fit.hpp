// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "deburr/vec3.hpp"

namespace deburr {

/// Right-handed orthonormal axes at a place; w is the one that heights are measured along.
struct Frame {
  Vec3 origin;
  Vec3 u, v, w;

  /// Coordinates of `p` in here.
  [[nodiscard]] Vec3 local(const Vec3& p) const {
    const Vec3 d = p - origin;
    return {dot(d, u), dot(d, v), dot(d, w)};
  }
};

/// A frame with the unit vector `w` for its third axis.
Frame frame_along(const Vec3& origin, const Vec3& w);

/// A height over a plane: z = c0 + c1 x + c2 y + c3 x^2 + c4 xy + c5 y^2.
struct HeightQuadric {
  std::array<double, 6> c{};

  [[nodiscard]] double height(double x, double y) const {
    return c[0] + x * (c[1] + c[3] * x + c[4] * y) + y * (c[2] + c[5] * y);
  }
  [[nodiscard]] double slope_x(double x, double y) const { return c[1] + 2 * c[3] * x + c[4] * y; }
  [[nodiscard]] double slope_y(double x, double y) const { return c[2] + c[4] * x + 2 * c[5] * y; }
};

/// A quadric of least squares and how far the points are from it.
struct QuadricFit {
  HeightQuadric surface;
  std::size_t count = 0;  ///< points
  std::size_t rank = 0;   ///< coefficients that the points determine, 0 to 6; the others are 0
  double squares = 0;     ///< sum of the squared differences in height

  /// Degrees of freedom that are left to the residuals.
  [[nodiscard]] double freedom() const {
    return count > rank ? static_cast<double>(count - rank) : 0.0;
  }
  /// Unbiased estimate of the variance of the heights about the surface; 0 without freedom.
  [[nodiscard]] double variance() const { return freedom() > 0 ? squares / freedom() : 0.0; }
};

/// Fits a quadric to heights z over (x, y) by least squares.
/// @param scale  a length that x and y are of the order of, > 0
/// Points on a line, or on a conic, do not determine all six coefficients: those of higher order
/// are then left out.
QuadricFit fit_quadric(std::span<const Vec3> points, double scale);

}  // namespace deburr

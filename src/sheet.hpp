// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "quadric_fit.hpp"

namespace deburr {

/// What is known of the surface around one node: a height over a plane, and how sure it is.
struct Sheet {
  Frame frame;  ///< its origin is the place of the node, its third axis the normal there
  HeightQuadric height;
  double variance = 0;  ///< of the height at the origin
  double radius = 0;    ///< of the points that the fit is made of
  bool valid = false;

  /// Where a point meets the sheet, going along the sheet's normal there, to first order.
  struct Meeting {
    double distance;  ///< signed, of the point
    Vec3 normal;      ///< unit
  };
  [[nodiscard]] Meeting meet(const Vec3& p) const {
    const Vec3 q = frame.local(p);
    const double a = height.slope_x(q.x, q.y);
    const double b = height.slope_y(q.x, q.y);
    const double cosine = 1 / std::sqrt(1 + a * a + b * b);
    return {(q.z - height.height(q.x, q.y)) * cosine,
            cosine * (frame.w - a * frame.u - b * frame.v)};
  }
  /// The point of the sheet over the origin, and the normal there.
  [[nodiscard]] Vec3 middle() const { return frame.origin + height.c[0] * frame.w; }
  [[nodiscard]] Vec3 normal() const { return meet(middle()).normal; }
};

}  // namespace deburr

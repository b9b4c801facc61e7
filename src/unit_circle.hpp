// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace deburr {

/// A direction in the plane.
struct Direction {
  double cos = 1;
  double sin = 0;
};

/// Unit vectors at `steps` + 1 equal angles from 0 to 90 degrees, both included; a power of two.
/// Halving angles needs only square roots, which, other than std::sin, have the same bits on every
/// machine.
inline std::vector<Direction> quarter_circle(std::size_t steps) {
  std::vector<Direction> arc(steps + 1);
  arc[steps] = {0, 1};
  for (std::size_t step = steps; step > 1; step /= 2) {
    for (std::size_t i = 0; i < steps; i += step) {
      const double c = arc[i].cos + arc[i + step].cos;
      const double s = arc[i].sin + arc[i + step].sin;
      const double length = std::sqrt(c * c + s * s);
      arc[i + step / 2] = {c / length, s / length};
    }
  }
  return arc;
}

/// Unit vectors at `count` equal angles, counterclockwise from 0; a power of two >= 4.
inline std::vector<Direction> unit_circle(std::size_t count) {
  const std::vector<Direction> arc = quarter_circle(count / 4);
  std::vector<Direction> circle;
  circle.reserve(count);
  Direction quadrant;
  for (int k = 0; k < 4; ++k) {
    for (std::size_t i = 0; i < count / 4; ++i) {
      circle.push_back({quadrant.cos * arc[i].cos - quadrant.sin * arc[i].sin,
                        quadrant.sin * arc[i].cos + quadrant.cos * arc[i].sin});
    }
    quadrant = {-quadrant.sin, quadrant.cos};
  }
  return circle;
}

}  // namespace deburr

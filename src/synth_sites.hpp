// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "box.hpp"
#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "random.hpp"
#include "shapes.hpp"
#include "surface_sampler.hpp"

namespace deburr {

/// Where a point of a scan is taken.
struct Site {
  SurfacePoint at;
  std::uint32_t scanner = 0;  ///< which one sees it
};

/// Where the scanners stand: towards four corners of a cube that form a tetrahedron, one and a half
/// diagonals from the middle of the box.
[[nodiscard]] inline std::array<Vec3, 4> scanner_positions(const Box& box) {
  const double away = 1.5 * norm(box.high - box.low) / std::sqrt(3.0);
  const Vec3 centre = middle(box);
  return {centre + away * Vec3{1, 1, 1}, centre + away * Vec3{-1, -1, 1},
          centre + away * Vec3{1, -1, -1}, centre + away * Vec3{-1, 1, -1}};
}

}  // namespace deburr

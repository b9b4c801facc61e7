// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/vec3.hpp"

namespace deburr {

/// v / |v|, or (0, 0, 1) where |v| < 1e-10, as in the authors' program.
inline Vec3 unit(const Vec3& v) {
  const double length = norm(v);
  return length < 1e-10 ? Vec3{0, 0, 1} : (1 / length) * v;
}

/// Whether the last component that is not 0 is negative: true for one of v and -v.
inline bool points_down(const Vec3& v) {
  if (v.z != 0) return v.z < 0;
  return v.y != 0 ? v.y < 0 : v.x < 0;
}

inline bool is_zero(const Vec3& v) { return v == Vec3{}; }

}  // namespace deburr

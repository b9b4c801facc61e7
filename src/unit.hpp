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

inline bool is_zero(const Vec3& v) { return v == Vec3{}; }

}  // namespace deburr

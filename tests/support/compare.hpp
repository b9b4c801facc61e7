// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "deburr/vec3.hpp"

namespace deburr {

/// The message of the std::invalid_argument that `call` throws, or "" without one.
template <typename Call>
std::string invalid_argument_of(const Call& call) {
  try {
    call();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

/// Infinite if the sizes differ or an entry is not finite.
inline double max_difference(Points a, Points b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (a.size() != b.size()) return infinity;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 d = a[i] - b[i];
    if (!is_finite(d)) return infinity;
    largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  return largest;
}

/// The largest distance between entries, where the sign does not count.
inline double max_difference_of_lines(Normals a, Normals b) {
  double largest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    largest = std::max(largest, std::min(norm(a[i] - b[i]), norm(a[i] + b[i])));
  }
  return largest;
}

/// Angle between two directions in degrees; 90 where one is zero.
inline double angle(const Vec3& a, const Vec3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

/// Mean of f(i) over 0 .. n-1.
template <typename F>
double mean_of(std::size_t n, const F& f) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += f(i);
  return sum / static_cast<double>(n);
}

}  // namespace deburr

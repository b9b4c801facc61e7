// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sheet.hpp"

namespace deburr {

/// A valid sheet as points land on it, in half the bytes: without axes of its own, as the zeros of
///
///   f(e) = normal . e - e^T bend e / 2,  e = (x - place) / radius - lift.
///
/// That is the height over the plane of the sheet, over its slope in the middle, where e is 0. Only
/// the place and the size are in double precision: the rest has no unit, and single precision puts
/// points 1e-7 radii from where double precision does, at any scale.
struct PackedSheet {
  Vec3 place;            ///< of the node, to the bit: some are of several nodes
  double certainty = 0;  ///< one over the standard deviation of the height there
  std::array<float, 3> normal{};
  std::array<float, 3> lift{};  ///< from there to the middle
  std::array<float, 6> bend{};  ///< xx, xy, xz, yy, yz, zz
  float fineness = 0;           ///< of that deviation, over the radius
  bool valid = false;

  PackedSheet() = default;
  /// Not valid either where not all of it is finite, or the radius is 0.
  PackedSheet(const Sheet& sheet);  // NOLINT(google-explicit-constructor): what was fitted, kept

  [[nodiscard]] double per_radius() const { return certainty * fineness; }
  /// As of Sheet.
  [[nodiscard]] Vec3 middle() const { return place + (1 / per_radius()) * widened(lift); }
  [[nodiscard]] Sheet::Meeting meet(const Vec3& p) const {
    const Vec3 e = per_radius() * (p - place) - widened(lift);
    const Vec3 n = widened(normal);
    const Vec3 up = n - Vec3{bend[0] * e.x + bend[1] * e.y + bend[2] * e.z,
                             bend[1] * e.x + bend[3] * e.y + bend[4] * e.z,
                             bend[2] * e.x + bend[4] * e.y + bend[5] * e.z};
    const double cosine = 1 / norm(up);
    // f rises by the mean of its slopes at both ends.
    return {0.5 * dot(n + up, e) * cosine / per_radius(), cosine * up};
  }
  /// At the middle, a unit vector in double precision.
  [[nodiscard]] Vec3 unit_normal() const {
    const Vec3 n = widened(normal);
    return (1 / norm(n)) * n;
  }
  /// Of the angle between that and a unit vector, to 1e-6.
  [[nodiscard]] double cosine(const Vec3& v) const { return dot(widened(normal), v); }

 private:
  static Vec3 widened(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }
};
static_assert(sizeof(PackedSheet) == 88);

}  // namespace deburr

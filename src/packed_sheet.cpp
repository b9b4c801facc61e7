// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "packed_sheet.hpp"

#include "sym3.hpp"

namespace deburr {
namespace {

float narrow(double v) { return static_cast<float>(v); }
std::array<float, 3> narrow(const Vec3& v) { return {narrow(v.x), narrow(v.y), narrow(v.z)}; }

/// Twice the quadratic part of a height, over space.
Sym3 second_derivative(const Frame& frame, const HeightQuadric& height) {
  const auto& c = height.c;
  Sym3 b;
  b.add_outer(2 * c[3], frame.u);
  b.add_outer(2 * c[5], frame.v);
  // u v^T + v u^T
  b.add_outer(c[4], frame.u + frame.v);
  b.add_outer(-c[4], frame.u);
  b.add_outer(-c[4], frame.v);
  return b;
}

}  // namespace

PackedSheet::PackedSheet(const Sheet& sheet)
    : place(sheet.frame.origin),
      certainty(1 / std::sqrt(sheet.variance)),
      fineness(narrow(1 / (certainty * sheet.radius))) {
  const Frame& frame = sheet.frame;
  const auto& c = sheet.height.c;
  const Vec3 slope = frame.w - c[1] * frame.u - c[2] * frame.v;
  const double cosine = 1 / norm(slope);
  normal = narrow(cosine * slope);
  lift = narrow((per_radius() * c[0]) * frame.w);
  Sym3 b = second_derivative(frame, sheet.height);
  b.scale(cosine / per_radius());
  bend = {narrow(b.xx), narrow(b.xy), narrow(b.xz), narrow(b.yy), narrow(b.yz), narrow(b.zz)};
  valid = sheet.valid && is_finite(middle());
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_blend.hpp"

#include <algorithm>

#include "belonging.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

constexpr double blend_radius = 0.7;  ///< of a sheet's own radius
constexpr double own_share = 0.1;     ///< at least, of the sheet of the point's own node

}  // namespace

Blend blend_sheets(const Vec3& point, const Vec3& place, std::uint32_t own,
                   std::span<const Found> near, std::span<const Sheet> sheets,
                   const BlendScales& scales) {
  if (!sheets[own].valid) return {};
  const double reach = height_reach(scales.noise, scales.spacing);
  const Sheet::Meeting at_own = sheets[own].meet(place);
  Vec3 move;
  Vec3 normals;
  double total = 0;
  for (const Found& f : near) {
    const Sheet& sheet = sheets[f.index];
    if (!sheet.valid) continue;
    const double radius = blend_radius * sheet.radius;
    double w = 1 - f.squared_distance / (radius * radius);
    if (f.index == own) w = std::max(w, own_share);
    if (!(w > 0)) continue;
    const Sheet::Meeting here = sheet.meet(place);
    const double off = here.distance / reach;
    w *= w * belonging(squared_norm(here.normal - at_own.normal), off) / sheet.variance;
    if (!(w > 0)) continue;
    const Sheet::Meeting m = sheet.meet(point);
    move += (-w * m.distance) * m.normal;
    normals += w * m.normal;
    total += w;
  }
  if (!(total > 0)) return {};
  return {point + (1 / total) * move, unit(normals), true};
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_blend.hpp"

#include <algorithm>
#include <array>

#include "belonging.hpp"
#include "lane_spectrum.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

constexpr double blend_radius = 0.7;  ///< of a sheet's own radius
constexpr double own_share = 0.1;     ///< at least, of the sheet of the point's own node

/// As in belonging.hpp, in lanes.
DEBURR_LANES_INLINE Lanes flat_top(const Lanes& e) {
  const Lanes t = 1.0 - e * e * (1.0 / 9);
  const Lanes t2 = t * t;
  const Lanes t4 = t2 * t2;
  return e < 3.0 ? t4 * t4 : Lanes{};
}

using EightSheets = std::array<const PackedSheet*, lane_count>;

template <typename Get>
DEBURR_LANES_INLINE Lanes column(const EightSheets& sheets, const Get& get) {
  Lanes v;
  for (std::size_t l = 0; l < lane_count; ++l) v[l] = get(*sheets[l]);
  return v;
}
#define DEBURR_COLUMN(member) \
  column(                     \
      sheets, [](const PackedSheet& s) __attribute__((always_inline)) { return s.member; })

/// Eight sheets.
struct LaneSheets {
  Lanes3 place, lift, normal;
  LanesSym3 bend;
  Lanes per_radius;

  DEBURR_LANES_INLINE void read(const EightSheets& sheets) {
    place = {DEBURR_COLUMN(place.x), DEBURR_COLUMN(place.y), DEBURR_COLUMN(place.z)};
    lift = {DEBURR_COLUMN(lift[0]), DEBURR_COLUMN(lift[1]), DEBURR_COLUMN(lift[2])};
    normal = {DEBURR_COLUMN(normal[0]), DEBURR_COLUMN(normal[1]), DEBURR_COLUMN(normal[2])};
    bend = {DEBURR_COLUMN(bend[0]), DEBURR_COLUMN(bend[1]), DEBURR_COLUMN(bend[2]),
            DEBURR_COLUMN(bend[3]), DEBURR_COLUMN(bend[4]), DEBURR_COLUMN(bend[5])};
  }
};

/// PackedSheet::meet() in lanes; heights are in radii.
struct LaneMeeting {
  Lanes height;
  Lanes3 normal;
};
DEBURR_LANES_INLINE LaneMeeting meet(const LaneSheets& sheets, const Lanes3& p) {
  const Lanes3 e = sheets.per_radius * (p - sheets.place) - sheets.lift;
  const LanesSym3& b = sheets.bend;
  const Lanes3 up = sheets.normal - Lanes3{b.xx * e.x + b.xy * e.y + b.xz * e.z,
                                           b.xy * e.x + b.yy * e.y + b.yz * e.z,
                                           b.xz * e.x + b.yz * e.y + b.zz * e.z};
  const Lanes cosine = 1.0 / sqrt(dot(up, up));
  return {0.5 * dot(sheets.normal + up, e) * cosine, cosine * up};
}

struct Sums {
  Vec3 move;
  Vec3 normals;
  double total = 0;
};

/// @param turned_from  normal of the own sheet
DEBURR_MULTIVERSION
Sums add_up(const Vec3& point, const Vec3& place, std::uint32_t own, std::span<const Found> near,
            const PackedSheet* all, double reach, const Vec3& turned_from) {
  Lanes3 move;
  Lanes3 normals;
  Lanes total{};
  for (std::size_t i = 0; i < near.size(); i += lane_count) {
    EightSheets sheets;
    Lanes square;
    Lanes least{};
    for (std::size_t l = 0; l < lane_count; ++l) {
      // Lanes beyond the last sheet have something to work on, and no weight.
      const Found& f = near[std::min(i + l, near.size() - 1)];
      sheets[l] = all + f.index;
      square[l] = f.squared_distance;
      least[l] = f.index == own ? own_share : 0;
    }
    LaneSheets lanes;
    const Lanes certainty = DEBURR_COLUMN(certainty);
    lanes.per_radius = certainty * DEBURR_COLUMN(fineness);
    Lanes w =
        1.0 - square * lanes.per_radius * lanes.per_radius * (1 / (blend_radius * blend_radius));
    w = w < least ? least : w;
    w = present(near.size(), i) > 0.0 ? w : Lanes{};
    if (!any(w > 0.0)) continue;
    lanes.read(sheets);
    const LaneMeeting here = meet(lanes, all_lanes(place));
    const Lanes radius = 1.0 / lanes.per_radius;
    const Lanes off = here.height * radius * (1 / reach);
    const Lanes3 turn = here.normal - all_lanes(turned_from);
    w *= w * certainty * certainty *
         flat_top(dot(turn, turn) * (1 / (normal_reach * normal_reach)) + off * off);
    // Neither does what is not finite have a weight, nor may it be counted 0 times.
    const LaneBits counts = w > 0.0;
    w = counts ? w : Lanes{};
    const LaneMeeting there = meet(lanes, all_lanes(point));
    const Lanes3 normal = choose(counts, there.normal, Lanes3{});
    const Lanes height = counts ? there.height * radius : Lanes{};
    move = move - (w * height) * normal;
    normals = normals + w * normal;
    total += w;
  }
  return {sum(move), sum(normals), sum(total)};
}

}  // namespace

Blend blend_sheets(const Vec3& point, const Vec3& place, std::uint32_t own,
                   std::span<const Found> near, std::span<const PackedSheet> sheets,
                   const BlendScales& scales) {
  const double reach = height_reach(scales.noise, scales.spacing);
  const Sums sums =
      add_up(point, place, own, near, sheets.data(), reach, sheets[own].meet(place).normal);
  if (!(sums.total > 0)) return {};
  return {point + (1 / sums.total) * sums.move, unit(sums.normals), true};
}

}  // namespace deburr

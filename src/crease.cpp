// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "crease.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "three_planes.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

constexpr double opposite = -0.9;  ///< the far side of a thin part ends no sheet
constexpr std::size_t fewest_members = 3;
constexpr std::size_t most_planes = 2;  ///< besides the own one: three make a corner
constexpr double near_share = 0.8;      ///< of the reach, from a sheet to a corner of it
constexpr double clear_majority = 0.5;  ///< of the members, on one side of a plane

/// A sheet is none of its own if its surest fit has so many times the variance of the surest
/// around.
constexpr double most_variance = 30;

/// Points of an edge are those within so many spacings of it.
constexpr double edge_width = 1;

constexpr double rounding = 1e-6;   ///< of cosines in single precision, at most
constexpr double one_place = 1e-9;  ///< in spacings: places closer than that differ by rounding

/// The nearest point to `at` on the line where plane `normal` through `at` meets another plane.
std::optional<Vec3> onto_line(const Vec3& at, const Vec3& normal, const Vec3& other,
                              double distance) {
  const Vec3 across = other - dot(other, normal) * normal;
  const double square = squared_norm(across);
  if (!(square > 1 - other_sheet * other_sheet)) return std::nullopt;
  return at - (distance / square) * across;
}

bool comes_near(std::span<const Vec3> members, const Vec3& place, double distance) {
  return std::ranges::any_of(
      members, [&](const Vec3& p) { return squared_norm(p - place) < distance * distance; });
}

}  // namespace

double CreaseFinder::side_of(const Plane& plane, std::span<const Vec3> members) const {
  const double clear = 0.25 * scales_.spacing;
  double sum = 0;
  double count = 0;
  for (const Vec3& p : members) {
    const double d = plane.distance(p);
    if (std::abs(d) < clear) continue;
    sum += d > 0 ? 1 : -1;
    count += 1;
  }
  if (count < static_cast<double>(fewest_members)) return 0;
  if (std::abs(sum) < clear_majority * count) return 0;
  return sum > 0 ? 1 : -1;
}

std::vector<CreaseFinder::Plane> CreaseFinder::find_planes(const Blend& blend, std::uint32_t own,
                                                           std::span<const Found> near) const {
  struct Candidate {
    Vec3 middle;
    Vec3 normal;
    double certainty;
  };
  std::vector<Candidate> candidates;
  const double limit = reach() * reach();
  for (const Found& f : near) {
    const PackedSheet& sheet = sheets_[f.index];
    // Most points are far from any edge, and this is all that is done for them.
    const double roughly = sheet.cosine(blend.normal);
    if (roughly > other_sheet + rounding || roughly < opposite - rounding) continue;
    const Vec3 middle = sheet.middle();
    const Vec3 normal = sheet.unit_normal();
    const double cosine = dot(normal, blend.normal);
    if (cosine >= other_sheet || cosine < opposite) continue;
    if (squared_norm(middle - blend.foot) > limit) continue;
    // What the own sheet's curvature explains is no edge.
    if (dot(sheets_[own].meet(middle).normal, normal) > other_sheet) continue;
    candidates.push_back({middle, normal, sheet.certainty});
  }
  if (candidates.size() < fewest_members) return {};
  std::vector<Vec3> own_members;
  double surest = sheets_[own].certainty;
  for (const Found& f : near) {
    const PackedSheet& sheet = sheets_[f.index];
    surest = std::max(surest, sheet.certainty);
    if (sheet.cosine(blend.normal) > same_sheet) own_members.push_back(sheet.middle());
  }
  std::vector<Plane> planes;
  while (planes.size() < most_planes && candidates.size() >= fewest_members) {
    // The surest sheet leads; those that agree with it join.
    const auto lead = std::ranges::max_element(candidates, {}, &Candidate::certainty);
    if (most_variance * lead->certainty * lead->certainty < surest * surest) break;
    const Vec3 direction = lead->normal;
    Plane plane;
    Vec3 normals;
    Vec3 center;
    double total = 0;
    for (const Candidate& c : candidates) {
      if (dot(c.normal, direction) < same_sheet) continue;
      const double w = c.certainty * c.certainty;
      normals += w * c.normal;
      center += w * c.middle;
      total += w;
      plane.members.push_back(c.middle);
    }
    std::erase_if(candidates,
                  [&](const Candidate& c) { return dot(c.normal, direction) > other_sheet; });
    if (plane.members.size() < fewest_members) continue;
    plane.normal = unit(normals);
    plane.offset = dot(plane.normal, (1 / total) * center);
    plane.side = side_of(plane, own_members);
    planes.push_back(std::move(plane));
  }
  return planes;
}

void CreaseFinder::find_shares(const Vec3& point, const Plane& self, std::span<const Plane> planes,
                               Landing& landing) const {
  std::array<const Plane*, most_sheets> all{&self};
  std::size_t count = 1;
  for (const Plane& plane : planes) {
    if (plane.meets) all[count++] = &plane;
  }
  if (count == 1) return;  // on its own sheet it is where it landed
  Sides side{};
  for (std::size_t k = 0; k < count; ++k) {
    const Plane& plane = *all[k];
    landing.sheets[k] = {point - plane.distance(point) * plane.normal, plane.normal};
    if (k == 0) continue;
    side[k][0] = plane.side;
    for (std::size_t j = 0; j < count; ++j) {
      if (j != k) side[j][k] = side_of(*all[j], plane.members);
    }
  }
  landing.sheet_count = count;
  set_shares(point, std::span(landing.sheets).first(count), side, scales_.noise);
  for (std::size_t k = 0; k < count; ++k) {
    Vec3& foot = landing.sheets[k].foot;
    for (std::size_t j = 0; j < count; ++j) {
      if (j == k) continue;
      const double d = all[j]->distance(foot);
      if (side[j][k] * d >= 0) continue;
      if (const auto edge = onto_line(foot, all[k]->normal, all[j]->normal, d)) foot = *edge;
    }
    // What lies on one edge is one place: rounding must not tell which of two sheets is nearer.
    for (std::size_t j = 0; j < k; ++j) {
      const Vec3& other = landing.sheets[j].foot;
      if (norm(foot - other) < one_place * spacing_) foot = other;
    }
  }
}

Landing CreaseFinder::land(const Vec3& point, const Blend& blend, std::uint32_t own,
                           std::span<const Found> near) const {
  Landing landing{blend.foot, blend.normal};
  landing.sheets[0] = {blend.foot, blend.normal};
  std::vector<Plane> planes = find_planes(blend, own, near);
  const Plane self{blend.normal, dot(blend.normal, blend.foot)};
  double nearest_edge = edge_width * spacing_;
  for (Plane& plane : planes) {
    const double d = plane.distance(blend.foot);
    const auto edge = onto_line(blend.foot, blend.normal, plane.normal, d);
    if (!edge) continue;
    // The two must really come near each other there.
    if (!comes_near(plane.members, *edge, reach())) continue;
    plane.meets = true;
    if (d * plane.side < 0) {
      if (landing.label != Feature::Surface) continue;  // beyond another edge already
      landing.place = *edge;
      landing.label = Feature::Edge;
      // The other sheet may be nearer than the edge.
      const Vec3 there = point - plane.distance(point) * plane.normal;
      Plane back = self;
      back.side = side_of(self, plane.members);
      if (back.side * back.distance(there) > 0 &&
          squared_norm(there - point) < squared_norm(*edge - point)) {
        landing.place = there;
        landing.normal = plane.normal;
        const auto its_edge = onto_line(there, plane.normal, self.normal, back.distance(there));
        if (its_edge && norm(*its_edge - there) > nearest_edge) landing.label = Feature::Surface;
      }
    } else if (norm(*edge - blend.foot) < nearest_edge) {
      landing.label = Feature::Edge;
    }
  }
  find_shares(point, self, planes, landing);
  if (planes.size() < most_planes) return landing;
  const auto corner = three_planes_meet(self.normal, self.offset, planes[0].normal,
                                        planes[0].offset, planes[1].normal, planes[1].offset);
  if (!corner) return landing;
  const bool meet = std::ranges::all_of(planes, [&](const Plane& plane) {
    return comes_near(plane.members, *corner, near_share * reach());
  });
  if (!meet) return landing;
  const bool beyond_both = std::ranges::all_of(planes, [&](const Plane& plane) {
    return plane.side != 0 && plane.distance(landing.place) * plane.side < one_place * spacing_;
  });
  const double to_corner = norm(*corner - landing.place);
  if (beyond_both && to_corner < reach()) {
    landing.place = *corner;
    landing.label = Feature::Corner;
  }
  return landing;
}

}  // namespace deburr

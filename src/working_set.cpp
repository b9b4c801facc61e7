// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "working_set.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "box.hpp"
#include "columns.hpp"
#include "near_duplicates.hpp"
#include "parallel.hpp"
#include "spatial_order.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

std::vector<std::uint32_t> finite_points(Points points, const Execution& execution) {
  std::vector<std::uint32_t> finite;
  pick(
      points.size(), [&](std::size_t i) { return is_finite(points[i]); },
      [&](std::size_t count) { resize_column(finite, count, execution); },
      [&](std::size_t i, std::size_t k) { finite[k] = static_cast<std::uint32_t>(i); }, execution);
  return finite;
}

/// A given normal as a unit vector, or zero where it is none.
Vec3 usable_normal(const Vec3& n) {
  const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  if (!is_finite(n) || !(largest > 0)) return {};
  // Unit ones stay as they are: a published run starts from the very bits of the file.
  if (std::abs(norm(n) - 1) < 1e-6) return n;
  const Vec3 scaled{n.x / largest, n.y / largest, n.z / largest};  // its square cannot overflow
  return (1 / norm(scaled)) * scaled;
}

/// One of the normals of two points at the same place, by value alone: neither their order nor
/// their signs matter.
Vec3 choose_normal(const Vec3& a, const Vec3& b) {
  if (is_zero(a) || is_zero(b)) return is_zero(a) ? b : a;
  const Vec3 p = points_down(a) ? -a : a;
  const Vec3 q = points_down(b) ? -b : b;
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z) ? p : q;
}

/// Leaves out the points that another one stands for; it gets their normal if it has none.
void merge_near_duplicates(WorkingSet& set, const Execution& execution) {
  const std::vector<std::uint32_t> standing = find_near_duplicates(set.points, execution);
  if (standing.empty()) return;
  std::vector<std::uint32_t> place(standing.size());
  std::uint32_t kept = 0;
  CancelWatch watch(execution);
  for (std::uint32_t i = 0; i < standing.size(); ++i) {
    watch();
    if (standing[i] == i) {
      place[i] = kept++;
      set.points[place[i]] = set.points[i];
      if (!set.normals.empty()) set.normals[place[i]] = set.normals[i];
    } else {  // the one that stands for it comes earlier
      place[i] = place[standing[i]];
      if (set.normals.empty()) continue;
      set.normals[place[i]] = choose_normal(set.normals[place[i]], set.normals[i]);
    }
  }
  set.points.resize(kept);
  if (!set.normals.empty()) set.normals.resize(kept);
  std::size_t counted = 0;
  for (std::uint32_t& slot : set.slot) {
    if (slot == WorkingSet::none) continue;
    slot = place[slot];
    ++counted;
  }
  set.duplicates = counted - kept;
}

/// Fills the set with points, normals and slots, along a curve in space.
void place_points(const PointCloud& cloud, std::span<const std::uint32_t> finite, bool merge,
                  WorkingSet& set, const Execution& execution) {
  const bool has_normals = !cloud.normals.empty();
  std::vector<std::uint32_t> order;
  {
    const std::vector<Vec3> candidates = gather<Vec3>(cloud.points, finite, execution);
    order = spatial_order(candidates, execution);
  }
  resize_column(set.points, finite.size(), execution);
  if (has_normals) resize_column(set.normals, finite.size(), execution);
  parallel_for(finite.size(), without_progress(execution), [&](std::size_t at) {
    order[at] = finite[order[at]];
    set.points[at] = cloud.points[order[at]];
    if (has_normals) set.normals[at] = usable_normal(cloud.normals[order[at]]);
  });
  // Those at the same place follow each other.
  CancelWatch watch(execution);
  std::uint32_t kept = 0;
  for (std::size_t at = 0; at < finite.size(); ++at) {
    watch();
    const bool duplicate = at > 0 && set.points[at] == set.points[kept - 1];
    if (duplicate) ++set.duplicates;
    if (!duplicate || !merge) {
      set.points[kept] = set.points[at];
      if (has_normals) set.normals[kept] = set.normals[at];
      ++kept;
    } else if (has_normals) {
      set.normals[kept - 1] = choose_normal(set.normals[kept - 1], set.normals[at]);
    }
    set.slot[order[at]] = kept - 1;
  }
  set.points.resize(kept);
  if (has_normals) set.normals.resize(kept);
}

/// Moves and scales points (by a power of two, which is exact); returns the exponent.
int make_local(std::vector<Vec3>& points, const Execution& execution) {
  const Box box = bounding_box(points);
  const Vec3 origin = middle(box);
  const Vec3 half = half_extent(box);
  const double largest = std::max({half.x, half.y, half.z});
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  // In two steps, since one alone could be beyond the largest double.
  const double first = std::scalbn(1.0, -exponent / 2);
  const double second = std::scalbn(1.0, -exponent - -exponent / 2);
  parallel_for(points.size(), without_progress(execution),
               [&](std::size_t i) { points[i] = second * (first * (points[i] - origin)); });
  return exponent;
}

}  // namespace

Vec3 WorkingSet::moved(const Vec3& in_cloud, const Vec3& from, const Vec3& to) const {
  if (from == to) return in_cloud;
  const Vec3 d = to - from;
  const Vec3 place = in_cloud + Vec3{length(d.x), length(d.y), length(d.z)};
  return is_finite(place) ? place : in_cloud;  // beyond the largest double
}

double WorkingSet::length(double local) const { return unit * local; }

WorkingSet set_of_distinct(std::vector<Vec3> points) {
  WorkingSet set;
  set.points = std::move(points);
  set.slot.resize(set.points.size());
  std::iota(set.slot.begin(), set.slot.end(), 0U);
  return set;
}

WorkingSet make_working_set(const PointCloud& cloud, const WorkingSetOptions& options,
                            const Execution& execution) {
  WorkingSet set;
  const std::vector<std::uint32_t> finite = finite_points(cloud.points, execution);
  set.non_finite = cloud.size() - finite.size();
  set.slot.assign(cloud.size(), WorkingSet::none);
  place_points(cloud, finite, options.merge_duplicates, set, execution);
  if (options.local_coordinates && !set.points.empty()) {
    set.exponent = make_local(set.points, execution);
    set.unit = std::scalbn(1.0, set.exponent);
    // In local coordinates, where no square overflows.
    if (options.merge_duplicates) merge_near_duplicates(set, execution);
  }
  if (options.sweep) {
    set.sweep.reserve(finite.size());
    for (const std::uint32_t i : finite) set.sweep.push_back(set.slot[i]);
  }
  check_cancelled(execution);
  return set;
}

}  // namespace deburr

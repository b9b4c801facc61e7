// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "working_set.hpp"

#include <algorithm>
#include <cmath>

#include "box.hpp"
#include "spatial_order.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

std::vector<std::uint32_t> finite_points(Points points) {
  std::vector<std::uint32_t> finite;
  finite.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_finite(points[i])) finite.push_back(static_cast<std::uint32_t>(i));
  }
  return finite;
}

/// A given normal as a unit vector, or zero where it is none.
Vec3 usable_normal(const Vec3& n) {
  const double length = norm(n);
  if (!std::isfinite(length) || !(length > 0)) return {};
  // Unit ones stay as they are: a published run starts from the very bits of the file.
  return std::abs(length - 1) < 1e-6 ? n : (1 / length) * n;
}

/// Moves and scales points (by a power of two, which is exact); returns the exponent.
int make_local(std::vector<Vec3>& points) {
  const Box box = bounding_box(points);
  const Vec3 origin = middle(box);
  const Vec3 half = half_extent(box);
  const double largest = std::max({half.x, half.y, half.z});
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  for (Vec3& p : points) {
    const Vec3 d = p - origin;
    p = {std::scalbn(d.x, -exponent), std::scalbn(d.y, -exponent), std::scalbn(d.z, -exponent)};
  }
  return exponent;
}

}  // namespace

Vec3 WorkingSet::moved(const Vec3& in_cloud, const Vec3& from, const Vec3& to) const {
  if (from == to) return in_cloud;
  const Vec3 d = to - from;
  return in_cloud + Vec3{length(d.x), length(d.y), length(d.z)};
}

double WorkingSet::length(double local) const { return std::scalbn(local, exponent); }

WorkingSet make_working_set(const PointCloud& cloud, const WorkingSetOptions& options,
                            const Execution& execution) {
  WorkingSet set;
  const std::vector<std::uint32_t> finite = finite_points(cloud.points);
  set.non_finite = cloud.size() - finite.size();
  const std::vector<Vec3> candidates = gather<Vec3>(cloud.points, finite);
  set.slot.assign(cloud.size(), WorkingSet::none);
  for (const std::uint32_t c : spatial_order(candidates, execution)) {
    const bool duplicate = !set.points.empty() && candidates[c] == set.points.back();
    if (duplicate) ++set.duplicates;
    const Vec3 normal = cloud.normals.empty() ? Vec3{} : usable_normal(cloud.normals[finite[c]]);
    if (!duplicate || !options.merge_duplicates) {
      set.points.push_back(candidates[c]);
      set.normals.push_back(normal);
    } else if (is_zero(set.normals.back())) {
      set.normals.back() = normal;
    }
    set.slot[finite[c]] = static_cast<std::uint32_t>(set.points.size() - 1);
  }
  if (cloud.normals.empty()) set.normals = {};
  for (const std::uint32_t i : finite) set.sweep.push_back(set.slot[i]);
  if (options.local_coordinates && !set.points.empty()) set.exponent = make_local(set.points);
  return set;
}

}  // namespace deburr

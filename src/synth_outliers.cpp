// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "synth_outliers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deburr/error.hpp"
#include "triangle_bvh.hpp"

namespace deburr {
namespace {

constexpr std::size_t smallest_cluster = 15;
constexpr std::size_t largest_cluster = 60;

/// A point with each coordinate uniform in [0, 1).
Vec3 unit_cube_point(Random& random) {
  // The order in which the arguments of a call are evaluated is not specified.
  Vec3 p;
  p.x = random.uniform();
  p.y = random.uniform();
  p.z = random.uniform();
  return p;
}

Vec3 point_in(const Box& box, Random& random) {
  const Vec3 u = unit_cube_point(random);
  const Vec3 extent = box.high - box.low;
  return box.low + Vec3{u.x * extent.x, u.y * extent.y, u.z * extent.z};
}

Vec3 point_in_unit_ball(Random& random) {
  for (;;) {
    const Vec3 p = 2 * unit_cube_point(random) - Vec3{1, 1, 1};
    if (squared_norm(p) <= 1) return p;
  }
}

/// A size for the next cluster that leaves nothing, or enough for another one.
std::size_t cluster_size(std::size_t left, Random& random) {
  constexpr std::size_t choices = largest_cluster - smallest_cluster + 1;
  const auto size =
      smallest_cluster + static_cast<std::size_t>(random.uniform() * static_cast<double>(choices));
  if (left >= size + smallest_cluster) return size;
  return left <= largest_cluster ? left : left - smallest_cluster;
}

}  // namespace

Box outlier_box(const Box& box) {
  const Vec3 centre = middle(box);
  const Vec3 half = half_extent(box);
  const double least = 0.1 * norm(half);
  const Vec3 reach =
      2 * Vec3{std::max(half.x, least), std::max(half.y, least), std::max(half.z, least)};
  return {centre - reach, centre + reach};
}

std::vector<Vec3> scattered_outliers(std::size_t count, const Box& box, Random& random) {
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = point_in(box, random);
  return points;
}

std::vector<Vec3> clustered_outliers(std::size_t count, double radius, double clearance,
                                     const TriangleMesh& surface, const Box& box, Random& random) {
  std::vector<Vec3> points;
  if (count == 0) return points;
  const TriangleBvh bvh(surface);
  const auto find_centre = [&] {
    constexpr int most_tries = 100000;
    for (int i = 0; i < most_tries; ++i) {
      const Vec3 p = point_in(box, random);
      if (bvh.squared_distance(p) >= clearance * clearance) return p;
    }
    throw DataError(fmt::format(
        "synth.cluster_outliers: no place in twice the bounding box is {:.6g} off the surface",
        clearance));
  };
  points.reserve(count);
  while (points.size() < count) {
    const std::size_t size = cluster_size(count - points.size(), random);
    const Vec3 centre = find_centre();
    for (std::size_t i = 0; i < size; ++i) {
      points.push_back(centre + radius * point_in_unit_ball(random));
    }
  }
  return points;
}

}  // namespace deburr

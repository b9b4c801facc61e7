// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "triangle_bvh.hpp"

// Source: Woop, Benthin and Wald, Watertight ray/triangle intersection, 2013. The ray is sheared
// onto an axis; then the sign of one and the same product tells on which side of an edge it passes,
// for both triangles at the edge.

namespace deburr {
namespace {

using Axis = double Vec3::*;
constexpr std::array<Axis, 3> axes{&Vec3::x, &Vec3::y, &Vec3::z};
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

struct TriangleBvh::Ray {
  Ray(const Vec3& from, const Vec3& towards) : origin(from), direction(towards) {
    std::size_t along = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(towards.*axes.at(k)) > std::abs(towards.*axes.at(along))) along = k;
    }
    kz = axes.at(along);
    kx = axes.at((along + 1) % 3);
    ky = axes.at((along + 2) % 3);
    shear_x = towards.*kx / towards.*kz;
    shear_y = towards.*ky / towards.*kz;
  }

  /// Where the ray enters a box; infinite if it does not.
  [[nodiscard]] double entry(const Box& box) const {
    double enter = 0;
    double leave = infinity;
    for (const Axis axis : axes) {
      const double d = direction.*axis;
      const double low = box.low.*axis - origin.*axis;
      const double high = box.high.*axis - origin.*axis;
      if (d == 0) {
        if (low > 0 || high < 0) return infinity;
        continue;
      }
      const double a = low / d;
      const double b = high / d;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    // A few roundings more, so that no triangle at the border of its box is lost.
    constexpr double margin = 1 + 8 * std::numeric_limits<double>::epsilon();
    if (enter > leave * margin) return infinity;
    return enter;
  }

  /// The hit of a triangle, at an infinite distance if there is none.
  [[nodiscard]] RayHit meet(const Triangle& triangle, std::uint32_t index) const {
    const Vec3 a = triangle[0] - origin;
    const Vec3 b = triangle[1] - origin;
    const Vec3 c = triangle[2] - origin;
    const double ax = a.*kx - shear_x * a.*kz;
    const double ay = a.*ky - shear_y * a.*kz;
    const double bx = b.*kx - shear_x * b.*kz;
    const double by = b.*ky - shear_y * b.*kz;
    const double cx = c.*kx - shear_x * c.*kz;
    const double cy = c.*ky - shear_y * c.*kz;
    const double u = cx * by - cy * bx;
    const double v = ax * cy - ay * cx;
    const double w = bx * ay - by * ax;
    const RayHit miss{infinity, index, {}};
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return miss;
    const double sum = u + v + w;
    if (sum == 0) return miss;  // seen edge-on, or without area
    const double distance = (u * a.*kz + v * b.*kz + w * c.*kz) / sum / direction.*kz;
    if (!(distance > 0)) return miss;
    return {distance, index,
            triangle[0] + v / sum * (triangle[1] - triangle[0]) +
                w / sum * (triangle[2] - triangle[0])};
  }

  Vec3 origin;
  Vec3 direction;
  Axis kx, ky, kz;  ///< kz is where the direction is largest
  double shear_x, shear_y;
};

std::optional<RayHit> TriangleBvh::first_hit(const Vec3& origin, const Vec3& direction) const {
  std::optional<RayHit> first;
  search(0, Ray(origin, direction), first);
  return first;
}

void TriangleBvh::search(std::uint32_t node, const Ray& ray, std::optional<RayHit>& first) const {
  const Node& n = nodes_[node];
  if (n.right == 0) {
    for (std::uint32_t i = n.begin; i < n.end; ++i) {
      const RayHit hit = ray.meet(triangles_[i], indices_[i]);
      if (hit.distance == infinity) continue;
      if (!first || hit.distance < first->distance ||
          (hit.distance == first->distance && hit.triangle < first->triangle)) {
        first = hit;
      }
    }
    return;
  }
  std::uint32_t near = node + 1;
  std::uint32_t far = n.right;
  double to_near = ray.entry(nodes_[near].box);
  double to_far = ray.entry(nodes_[far].box);
  if (to_far < to_near) {
    std::swap(near, far);
    std::swap(to_near, to_far);
  }
  // Boxes at the same distance count, since they may hold a triangle with a smaller index.
  const auto reaches = [&](double to_box) {
    return to_box < infinity && (!first || to_box <= first->distance);
  };
  if (reaches(to_near)) search(near, ray, first);
  if (reaches(to_far)) search(far, ray, first);
}

}  // namespace deburr

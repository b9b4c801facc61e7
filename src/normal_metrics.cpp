// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/normal_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "box.hpp"
#include "finite_cloud.hpp"
#include "mesh_check.hpp"
#include "parallel.hpp"
#include "triangle_bvh.hpp"
#include "triangle_normal.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The best angles of one point, in degrees, NaN if there is nothing to compare.
struct Angles {
  double unoriented = nothing;
  double oriented = nothing;

  void add(const Vec3& normal, const Vec3& truth) {
    const double sine = norm(cross(normal, truth));
    const double cosine = dot(normal, truth);
    const auto degrees = [&](double c) { return std::atan2(sine, c) * 180 / std::numbers::pi; };
    unoriented = std::fmin(unoriented, degrees(std::abs(cosine)));
    oriented = std::fmin(oriented, degrees(cosine));
  }
};

bool is_direction(const Vec3& n) { return is_finite(n) && !is_zero(n); }

/// With components up to 1, so that nothing overflows or vanishes in a product.
Vec3 scaled(const Vec3& n) { return (1 / largest_coordinate(n)) * n; }

/// Squared distance up to which others count as just as near, `largest` being a coordinate.
double with_rounding(double squared_distance, double largest) {
  const double reach =
      std::sqrt(squared_distance) + 16 * std::numeric_limits<double>::epsilon() * largest;
  return reach * reach;
}

/// Calls add(i, angles) for every point with a normal, in parallel, and takes the means.
template <typename Add>
NormalError mean_angles(Points points, Normals normals, const Execution& execution,
                        const Add& add) {
  std::vector<Angles> angles(points.size());
  parallel_for(points.size(), execution, [&](std::size_t i) {
    if (is_finite(points[i]) && is_direction(normals[i])) add(i, angles[i]);
  });
  NormalError error;
  for (const Angles& a : angles) {
    if (std::isnan(a.oriented)) continue;
    ++error.count;
    error.unoriented += a.unoriented;
    error.oriented += a.oriented;
  }
  if (error.count > 0) {
    error.unoriented /= static_cast<double>(error.count);
    error.oriented /= static_cast<double>(error.count);
  }
  return error;
}

}  // namespace

NormalError normal_error(Points points, Normals normals, const TriangleMesh& surface,
                         const Execution& execution) {
  require_size("normals", normals.size(), points.size());
  require_surface(surface);
  const TriangleBvh bvh(surface);
  const double largest =
      std::max(largest_coordinate(bvh.box().low), largest_coordinate(bvh.box().high));
  return mean_angles(points, normals, execution, [&](std::size_t i, Angles& angles) {
    const Vec3& p = points[i];
    const double limit =
        with_rounding(bvh.squared_distance(p), std::max(largest, largest_coordinate(p)));
    std::vector<std::uint32_t> found;
    bvh.within(p, limit, found);
    for (const std::uint32_t t : found) {
      const Vec3 truth = triangle_normal(triangle_of(surface, t));
      if (!is_zero(truth)) angles.add(scaled(normals[i]), truth);
    }
  });
}

NormalError normal_error(Points points, Normals normals, Points truth, Normals true_normals,
                         const Execution& execution) {
  require_size("normals", normals.size(), points.size());
  require_size("true_normals", true_normals.size(), truth.size());
  const FiniteCloud cloud(truth, execution,
                          [&](std::uint32_t i) { return is_direction(true_normals[i]); });
  if (cloud.empty()) return {};
  const Box box = bounding_box(cloud.points());
  const double largest = std::max(largest_coordinate(box.low), largest_coordinate(box.high));
  return mean_angles(points, normals, execution, [&](std::size_t i, Angles& angles) {
    const Vec3& p = points[i];
    const double limit = with_rounding(cloud.tree().nearest_to(p).squared_distance,
                                       std::max(largest, largest_coordinate(p)));
    std::vector<Found> found;
    cloud.tree().within_of(p, limit, found);
    for (const Found& f : found) {
      angles.add(scaled(normals[i]), scaled(true_normals[cloud.original(f.index)]));
    }
  });
}

}  // namespace deburr

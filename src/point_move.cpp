// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "point_move.hpp"

#include <Eigen/LU>

#include "sym3.hpp"

namespace deburr {
namespace {

/// Share of the trace that keeps the quadric of a feature away from singular. Directions in which
/// the neighbours' planes say less than this hardly move.
constexpr double regularisation = 0.01;

/// Determinant below which the authors' program takes a quadric for singular.
constexpr double published_singular = 1e-10;

/// Minimiser of the quadric, relative to the position x.
Vec3 minimise(const FeatureSums& sums, const Vec3& x, Quadric kind) {
  Eigen::Matrix3d m = sums.a.matrix();
  if (kind == Quadric::Guarded) {
    m.diagonal().array() += regularisation * sums.a.trace();
  } else if (std::abs(m.determinant()) < published_singular) {
    // The program then takes the right-hand side of the absolute system for the position.
    return sums.b + sums.a * x - x;
  }
  return to_vec3(m.inverse() * to_eigen(sums.b));
}

}  // namespace

Vec3 move_point(std::size_t i, const Vec3& original, const Oriented& cloud,
                const PointClass& point_class, std::span<const std::uint32_t> neighbors,
                const SurfaceSums& sums, std::size_t l, const PositionUpdateOptions& options) {
  const Vec3 x(cloud.points[i]);
  if (point_class.label == Feature::Isolated || neighbors.empty()) return x;
  Vec3 y;
  if (point_class.label == Feature::Surface) {
    y = x + (options.step * sums.offsets[l] / sums.total[l]) * Vec3(cloud.normals[i]);
  } else {
    FeatureSums planes;
    add_planes(i, cloud, neighbors, options, point_class.direction, planes);
    if (point_class.label == Feature::Edge) planes.a.add_outer(1, point_class.direction);
    y = x + options.feature_step * minimise(planes, x, options.quadric);
  }
  if (!is_finite(y)) return x;
  const Vec3 moved = y - original;
  if (options.bound == Bound::Reject) {
    return squared_norm(moved) < options.max_move * options.max_move ? y : x;
  }
  const double distance = norm(moved);
  return distance > options.max_move ? original + (options.max_move / distance) * moved : y;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "point_move.hpp"

#include <Eigen/LU>

#include "lanes.hpp"
#include "sym3.hpp"

namespace deburr {
namespace {

/// Share of the trace that keeps the quadric of a feature away from singular. Directions in which
/// the neighbours' planes say less than this hardly move.
constexpr double regularisation = 0.01;

/// Determinant below which the authors' program takes a quadric for singular.
constexpr double published_singular = 1e-10;

/// The neighbours of a point, and what their weights depend on.
struct Surroundings {
  std::size_t i;
  Points points;
  Normals normals;
  std::span<const std::uint32_t> neighbors;
};

/// Sums of weights and of weighted offsets along the normals.
struct SurfaceSums {
  double total = 0;
  double offsets = 0;
};

DEBURR_MULTIVERSION
void add_offsets(const Surroundings& s, const PositionUpdateOptions& options, SurfaceSums& sums) {
  const double position_factor = -1 / (options.position_scale * options.position_scale);
  const double normal_factor = -1 / (options.normal_scale * options.normal_scale);
  const bool projected = options.offset == Offset::Projected;
  const Lanes3 x = all_lanes(s.points[s.i]);
  const Lanes3 n = all_lanes(s.normals[s.i]);
  Lanes total{};
  Lanes offsets{};
  for (std::size_t k = 0; k < s.neighbors.size(); k += lane_count) {
    const Lanes3 d = load(s.points, s.neighbors, k) - x;
    const Lanes3 m = load(s.normals, s.neighbors, k);
    const Lanes3 turn = m - n;
    const Lanes w = present(s.neighbors.size(), k) *
                    exp_of_negative(position_factor * dot(d, d) + normal_factor * dot(turn, turn));
    const Lanes offset = projected ? dot(n, d) : 0.5 * (dot(n, d) + dot(m, d));
    total += w;
    offsets += w * offset;
  }
  sums = {sum(total), sum(offsets)};
}

/// The quadric of the neighbours' tangent planes: matrix and right-hand side, relative to the
/// point.
struct FeatureSums {
  Sym3 a;
  Vec3 b;
};

/// @param along  the edge, to leave out what lies along it; zero for a corner
DEBURR_MULTIVERSION
void add_planes(const Surroundings& s, const PositionUpdateOptions& options, const Vec3& along,
                FeatureSums& sums) {
  const bool weighted = options.quadric == Quadric::Guarded;
  const double position_factor = -1 / (options.position_scale * options.position_scale);
  const Lanes3 x = all_lanes(s.points[s.i]);
  const Lanes3 e = all_lanes(along);
  LanesSym3 a;
  Lanes3 b;
  for (std::size_t k = 0; k < s.neighbors.size(); k += lane_count) {
    const Lanes3 d = load(s.points, s.neighbors, k) - x;
    const Lanes3 m = load(s.normals, s.neighbors, k);  // zero beyond the end of the list
    const Lanes3 across = m - dot(m, e) * e;
    const Lanes w = weighted ? exp_of_negative(position_factor * dot(d, d)) : all_lanes(1);
    a.add_outer(w, across);
    b = b + (w * dot(across, d)) * across;
  }
  sums = {sum(a), sum(b)};
}

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

Vec3 move_point(std::size_t i, const Vec3& original, Points points, Normals normals,
                const PointClass& point_class, std::span<const std::uint32_t> neighbors,
                const PositionUpdateOptions& options) {
  const Vec3& x = points[i];
  if (point_class.label == Feature::Isolated || neighbors.empty()) return x;
  const Surroundings surroundings{i, points, normals, neighbors};
  Vec3 y;
  if (point_class.label == Feature::Surface) {
    SurfaceSums sums;
    add_offsets(surroundings, options, sums);
    y = x + (options.step * sums.offsets / sums.total) * normals[i];
  } else {
    FeatureSums sums;
    add_planes(surroundings, options, point_class.direction, sums);
    if (point_class.label == Feature::Edge) sums.a.add_outer(1, point_class.direction);
    y = x + options.feature_step * minimise(sums, x, options.quadric);
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

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "neighbor_sums.hpp"

namespace deburr {
namespace {

struct PointMoments {
  Lanes count{};
  Lanes3 sum;
  LanesSym3 outer;

  /// Returns 1 for neighbours that count, 0 for others.
  DEBURR_LANES_INLINE Lanes add(double rho, const Lanes3& n, const Lanes3& m, const Lanes3& d) {
    const Lanes similar = dot(n, m) > rho ? all_lanes(1) : Lanes{};
    count += similar;
    sum = sum + similar * d;
    outer.add_outer(similar, d);
    return similar;
  }
  DEBURR_LANES_INLINE void put(std::size_t l, Moments& to) const {
    to.count[l] = deburr::sum(count);
    set_lane(to.sum, l, deburr::sum(sum));
    set_lane(to.outer, l, deburr::sum(outer));
  }
};

struct PointOffsets {
  Lanes total{};
  Lanes offsets{};
  double position_factor;
  double normal_factor;
  bool projected;

  DEBURR_LANES_INLINE explicit PointOffsets(const PositionUpdateOptions& options)
      : position_factor(-1 / (options.position_scale * options.position_scale)),
        normal_factor(-1 / (options.normal_scale * options.normal_scale)),
        projected(options.offset == Offset::Projected) {}

  DEBURR_LANES_INLINE void add(const Lanes& there, const Lanes3& n, const Lanes3& m,
                               const Lanes3& d) {
    const Lanes3 turn = m - n;
    const Lanes w =
        there * exp_of_negative(position_factor * dot(d, d) + normal_factor * dot(turn, turn));
    const Lanes offset = projected ? dot(n, d) : 0.5 * (dot(n, d) + dot(m, d));
    total += w;
    offsets += w * offset;
  }
  DEBURR_LANES_INLINE void put(std::size_t l, SurfaceSums& to) const {
    to.total[l] = sum(total);
    to.offsets[l] = sum(offsets);
  }
};

}  // namespace

DEBURR_MULTIVERSION
void add_moments(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
                 double rho, std::size_t l, Moments& to) {
  const Lanes3 x = all_lanes(Vec3(cloud.points[i]));
  const Lanes3 n = all_lanes(Vec3(cloud.normals[i]));
  PointMoments moments;
  for (std::size_t k = 0; k < neighbors.size(); k += lane_count) {
    moments.add(rho, n, load(cloud.normals, neighbors, k), load(cloud.points, neighbors, k) - x);
  }
  moments.put(l, to);
}

DEBURR_MULTIVERSION
void add_offsets(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
                 const PositionUpdateOptions& options, std::size_t l, SurfaceSums& to) {
  const Lanes3 x = all_lanes(Vec3(cloud.points[i]));
  const Lanes3 n = all_lanes(Vec3(cloud.normals[i]));
  PointOffsets sums(options);
  for (std::size_t k = 0; k < neighbors.size(); k += lane_count) {
    sums.add(present(neighbors.size(), k), n, load(cloud.normals, neighbors, k),
             load(cloud.points, neighbors, k) - x);
  }
  sums.put(l, to);
}

DEBURR_MULTIVERSION
void add_both(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
              double rho, const PositionUpdateOptions& options, std::size_t l, Moments& moments,
              SurfaceSums& sums) {
  const Lanes3 x = all_lanes(Vec3(cloud.points[i]));
  const Lanes3 n = all_lanes(Vec3(cloud.normals[i]));
  PointMoments point_moments;
  PointOffsets point_sums(options);
  for (std::size_t k = 0; k < neighbors.size(); k += lane_count) {
    const Lanes3 d = load(cloud.points, neighbors, k) - x;
    const Lanes3 m = load(cloud.normals, neighbors, k);  // zero beyond the end of the list
    point_moments.add(rho, n, m, d);
    point_sums.add(present(neighbors.size(), k), n, m, d);
  }
  point_moments.put(l, moments);
  point_sums.put(l, sums);
}

DEBURR_MULTIVERSION
void add_all(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
             double rho, const PositionUpdateOptions& options, std::size_t l, Moments& moments,
             SurfaceSums& sums, Votes& votes) {
  const Lanes3 x = all_lanes(Vec3(cloud.points[i]));
  const Lanes3 n = all_lanes(Vec3(cloud.normals[i]));
  PointMoments point_moments;
  PointOffsets point_sums(options);
  LanesSym3 tensor;
  for (std::size_t k = 0; k < neighbors.size(); k += lane_count) {
    const Lanes3 d = load(cloud.points, neighbors, k) - x;
    const Lanes3 m = load(cloud.normals, neighbors, k);  // zero beyond the end of the list
    const Lanes vote = point_moments.add(rho, n, m, d);
    tensor.add_outer(vote, m);
    point_sums.add(present(neighbors.size(), k), n, m, d);
  }
  point_moments.put(l, moments);
  point_sums.put(l, sums);
  set_lane(votes.sum, l, sum(tensor));
  votes.count[l] = moments.count[l];
}

DEBURR_MULTIVERSION
void add_planes(std::size_t i, const Oriented& cloud, std::span<const std::uint32_t> neighbors,
                const PositionUpdateOptions& options, const Vec3& along, FeatureSums& to) {
  const bool weighted = options.quadric == Quadric::Guarded;
  const double position_factor = -1 / (options.position_scale * options.position_scale);
  const Lanes3 x = all_lanes(Vec3(cloud.points[i]));
  const Lanes3 e = all_lanes(along);
  LanesSym3 a;
  Lanes3 b;
  for (std::size_t k = 0; k < neighbors.size(); k += lane_count) {
    const Lanes3 d = load(cloud.points, neighbors, k) - x;
    const Lanes3 m = load(cloud.normals, neighbors, k);  // zero beyond the end of the list
    const Lanes3 across = m - dot(m, e) * e;
    const Lanes w = weighted ? exp_of_negative(position_factor * dot(d, d)) : all_lanes(1);
    a.add_outer(w, across);
    b = b + (w * dot(across, d)) * across;
  }
  to = {sum(a), sum(b)};
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "kd_tree.hpp"
#include "parallel.hpp"
#include "spatial_order.hpp"
#include "synth_sites.hpp"

namespace deburr {
namespace {

constexpr double sqrt3 = 1.7320508075688772;
/// Faces whose normals have a smaller cosine do not crowd each other.
constexpr double opposite = -0.5;

/// Half the distance of neighbours in the densest packing of as many discs as points there should
/// be, for every triangle.
std::vector<double> disc_radii(const SampledShape& shape, std::size_t count) {
  const std::size_t triangles = shape.mesh.triangles.size();
  const auto density = [&](std::size_t t) { return shape.density.empty() ? 1 : shape.density[t]; };
  double total = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto& [a, b, c] = shape.mesh.triangles[t];
    const Vec3& origin = shape.mesh.vertices[a];
    total += density(t) / 2 *
             norm(cross(shape.mesh.vertices[b] - origin, shape.mesh.vertices[c] - origin));
  }
  std::vector<double> radii(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    radii[t] = std::sqrt(total / (density(t) * static_cast<double>(count) * 2 * sqrt3));
  }
  return radii;
}

class Elimination {
 public:
  Elimination(const SampledShape& shape, const std::vector<SurfacePoint>& candidates,
              std::size_t count, const Execution& execution)
      : radii_(disc_radii(shape, count)),
        execution_(execution),
        order_(spatial_order(positions(candidates), without_progress(execution))),
        points_(gather<Vec3>(positions(candidates), order_)),
        tree_(points_, without_progress(execution)) {
    // Candidates closer than this crowd each other as if they were that far apart: without it the
    // first to go are pairs that lie close by chance.
    const double share = static_cast<double>(count) / static_cast<double>(candidates.size());
    least_ = 0.65 * (1 - share * std::sqrt(share));
    for (std::uint32_t t = 0; t < shape.mesh.triangles.size(); ++t) {
      normals_.push_back(triangle_normal(shape.mesh, t));
    }
    for (const std::uint32_t i : order_) triangles_.push_back(candidates[i].triangle);
  }

  /// Which candidates stay.
  std::vector<bool> run(std::size_t count) {
    const std::size_t size = points_.size();
    std::vector<double> crowding(size);
    parallel_for(size, sub_execution(execution_, "points", 0, 0.4), [&](std::size_t i) {
      thread_local std::vector<Found> found;
      visit(static_cast<std::uint32_t>(i), found,
            [&](std::uint32_t /*j*/, double weight) { crowding[i] += weight; });
    });
    // Crowding only ever falls, so an entry that is out of date comes up early, not late.
    std::priority_queue<std::pair<double, std::uint32_t>> queue;
    for (std::uint32_t i = 0; i < size; ++i) queue.emplace(crowding[i], i);
    std::vector<bool> stays(size, true);
    std::vector<Found> found;
    for (std::size_t left = size; left > count;) {
      const auto [value, i] = queue.top();
      queue.pop();
      if (value > crowding[i]) {
        queue.emplace(crowding[i], i);
        continue;
      }
      stays[order_[i]] = false;
      visit(i, found, [&](std::uint32_t j, double weight) { crowding[j] -= weight; });
      if (--left % block_size == 0) {
        check_cancelled(execution_);
        if (execution_.progress) {
          execution_.progress({"points", 1 - 0.6 * static_cast<double>(left - count) /
                                                 static_cast<double>(size - count)});
        }
      }
    }
    return stays;
  }

 private:
  static std::vector<Vec3> positions(const std::vector<SurfacePoint>& candidates) {
    std::vector<Vec3> points;
    points.reserve(candidates.size());
    for (const SurfacePoint& p : candidates) points.push_back(p.position);
    return points;
  }

  /// Calls tell(j, weight) for all that candidate i is crowded by; the
  /// weight is that of i on j as well.
  template <typename Tell>
  void visit(std::uint32_t i, std::vector<Found>& found, const Tell& tell) const {
    const double own = 2 * radii_[triangles_[i]];
    tree_.within(i, own * own, found);
    for (const auto& [squared_distance, j] : found) {
      const double reach = std::min(own, 2 * radii_[triangles_[j]]);
      const double distance = std::max(std::sqrt(squared_distance), least_ * reach);
      if (distance >= reach) continue;
      if (dot(normals_[triangles_[i]], normals_[triangles_[j]]) < opposite) continue;
      double weight = 1 - distance / reach;
      for (int k = 0; k < 3; ++k) weight *= weight;
      tell(j, weight);
    }
  }

  std::vector<double> radii_;  ///< of the triangles
  std::vector<Vec3> normals_;  ///< of the triangles
  const Execution& execution_;
  std::vector<std::uint32_t> order_;  ///< of the candidates in space, where neighbours are at hand
  std::vector<Vec3> points_;          ///< along that
  std::vector<std::uint32_t> triangles_;  ///< of the points
  KdTree tree_;
  double least_ = 0;
};

}  // namespace

std::vector<Site> poisson_sites(const SampledShape& shape, const SurfaceSampler& sampler,
                                std::size_t count, Random& random, const Execution& execution) {
  std::vector<SurfacePoint> candidates(candidates_per_point * count);
  for (SurfacePoint& p : candidates) p = sampler.place(random);
  const std::vector<bool> stays = Elimination(shape, candidates, count, execution).run(count);
  std::vector<Site> sites;
  sites.reserve(count);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (stays[i]) sites.push_back({candidates[i], 0});
  }
  return sites;
}

}  // namespace deburr

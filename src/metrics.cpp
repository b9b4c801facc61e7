// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/metrics.hpp"

#include <cmath>
#include <limits>

#include "box.hpp"
#include "distance_error.hpp"
#include "finite_cloud.hpp"
#include "mesh_check.hpp"
#include "parallel.hpp"
#include "random.hpp"
#include "surface_sampler.hpp"
#include "triangle_bvh.hpp"

namespace deburr {
namespace {

double diagonal(const TriangleMesh& surface) {
  const Box box = bounding_box(surface);
  return norm(box.high - box.low);
}

}  // namespace

std::vector<double> distance_to_surface(Points points, const TriangleMesh& surface,
                                        const Execution& execution) {
  require_surface(surface);
  const TriangleBvh bvh(surface);
  std::vector<double> distances(points.size());
  parallel_for(points.size(), execution, [&](std::size_t i) {
    distances[i] = is_finite(points[i]) ? std::sqrt(bvh.squared_distance(points[i]))
                                        : std::numeric_limits<double>::quiet_NaN();
  });
  return distances;
}

SurfaceError compare_to_surface(Points points, const TriangleMesh& surface,
                                const Execution& execution) {
  std::vector<double> distances = distance_to_surface(points, surface, execution);
  return summarize(std::move(distances), diagonal(surface));
}

DistanceError surface_coverage(Points points, const TriangleMesh& surface,
                               const CoverageOptions& options, const Execution& execution) {
  require_surface(surface);
  const SurfaceSampler sampler(surface);
  const FiniteCloud cloud(points, execution);
  std::vector<double> distances;
  if (!cloud.empty() && sampler.area() > 0) {
    // Drawn one after the other, so that the threads do not matter.
    Random random(options.seed);
    std::vector<Vec3> places(options.samples);
    for (Vec3& place : places) place = sampler.draw(random);
    distances.resize(options.samples);
    parallel_for(options.samples, execution, [&](std::size_t i) {
      distances[i] = std::sqrt(cloud.tree().nearest_to(places[i]).squared_distance);
    });
  }
  return summarize(std::move(distances), diagonal(surface));
}

double mean_spacing(const TriangleMesh& surface, std::size_t count) {
  require_surface(surface);
  if (count == 0) return 0;
  return std::sqrt(SurfaceSampler(surface).area() / static_cast<double>(count));
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "box.hpp"
#include "parallel.hpp"
#include "surface_check.hpp"
#include "triangle_bvh.hpp"

namespace deburr {
std::vector<double> distance_to_surface(Points points, const TriangleMesh& surface,
                                        const Execution& execution) {
  check_surface(surface);
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
  SurfaceError error;
  double sum = 0;
  double sum_of_squares = 0;
  for (const double d : distance_to_surface(points, surface, execution)) {
    if (std::isnan(d)) continue;
    ++error.count;
    sum += d;
    sum_of_squares += d * d;
    error.maximum = std::max(error.maximum, d);
  }
  if (error.count > 0) {
    error.mean = sum / static_cast<double>(error.count);
    error.rms = std::sqrt(sum_of_squares / static_cast<double>(error.count));
  }
  const Box box = bounding_box(surface);
  error.diagonal = norm(box.high - box.low);
  return error;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/cloud_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "box.hpp"
#include "distance_error.hpp"
#include "finite_cloud.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

std::vector<double> distances_to(const FiniteCloud& cloud, Points points,
                                 const Execution& execution) {
  std::vector<double> distances(points.size());
  parallel_for(points.size(), execution, [&](std::size_t i) {
    distances[i] = is_finite(points[i]) && !cloud.empty()
                       ? std::sqrt(cloud.tree().nearest_to(points[i]).squared_distance)
                       : std::numeric_limits<double>::quiet_NaN();
  });
  return distances;
}

/// Largest distance from the middle of the box.
double radius(const std::vector<Vec3>& points, const Box& box) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max(largest, norm(p - middle(box)));
  return largest;
}

}  // namespace

std::vector<double> distance_to_cloud(Points points, Points cloud, const Execution& execution) {
  return distances_to(FiniteCloud(cloud, execution), points, execution);
}

CloudError compare_to_cloud(Points points, Points truth, const Execution& execution) {
  const FiniteCloud cloud(points, execution);
  const FiniteCloud truths(truth, execution);
  CloudError error;
  error.chamfer = std::numeric_limits<double>::quiet_NaN();
  if (truths.empty()) return error;

  const Box box = bounding_box(truths.points());
  const double diagonal = norm(box.high - box.low);
  error.to_truth =
      summarize(distances_to(truths, cloud.points(), sub_execution(execution, "distances", 0, 0.5)),
                diagonal);
  error.coverage =
      summarize(distances_to(cloud, truths.points(), sub_execution(execution, "distances", 0.5, 1)),
                diagonal);
  const double unit = radius(truths.points(), box);
  if (unit > 0 && !cloud.empty()) {
    const double forth = error.to_truth.rms / unit;
    const double back = error.coverage.rms / unit;
    error.chamfer = 1e4 * (forth * forth + back * back);
  }
  return error;
}

}  // namespace deburr

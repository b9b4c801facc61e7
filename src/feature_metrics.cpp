// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/feature_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "finite_cloud.hpp"
#include "parallel.hpp"
#include "require.hpp"
#include "triangle_bvh.hpp"

namespace deburr {
namespace {

void require_spacing(double spacing) {
  require(std::isfinite(spacing) && spacing > 0, "spacing", "finite and > 0", spacing);
}

/// Finds the nearest of some segments: a triangle without area is one.
class Segments {
 public:
  explicit Segments(const std::vector<std::array<Vec3, 2>>& segments) {
    TriangleMesh mesh;
    for (const auto& [a, b] : segments) {
      const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.insert(mesh.vertices.end(), {a, b});
      mesh.triangles.push_back({next, next + 1, next + 1});
    }
    if (!mesh.triangles.empty()) bvh_.emplace(mesh);
  }

  [[nodiscard]] double squared_distance(const Vec3& p) const {
    return bvh_ ? bvh_->squared_distance(p) : std::numeric_limits<double>::infinity();
  }

 private:
  std::optional<TriangleBvh> bvh_;
};

double share(double part, double whole) {
  return whole > 0 ? part / whole : std::numeric_limits<double>::quiet_NaN();
}

bool has_within(const FiniteCloud& cloud, const Vec3& at, double reach) {
  return !cloud.empty() && cloud.tree().nearest_to(at).squared_distance <= reach * reach;
}

double length(const std::array<Vec3, 2>& edge) { return norm(edge[1] - edge[0]); }

/// Length of the part of an edge that has a point within reach.
double length_seen(const std::array<Vec3, 2>& edge, const FiniteCloud& cloud, double reach,
                   double step) {
  // Not even billions of points need as many as the limit.
  const auto pieces =
      static_cast<std::size_t>(std::clamp(std::ceil(length(edge) / step), 1.0, 1e7));
  std::size_t seen = 0;
  for (std::size_t k = 0; k < pieces; ++k) {
    const double at = (static_cast<double>(k) + 0.5) / static_cast<double>(pieces);
    if (has_within(cloud, edge[0] + at * (edge[1] - edge[0]), reach)) ++seen;
  }
  return static_cast<double>(seen) / static_cast<double>(pieces) * length(edge);
}

}  // namespace

FeatureScore score_features(Points points, std::span<const Feature> labels,
                            const SharpFeatures& truth, double spacing,
                            const Execution& execution) {
  require_size("labels", labels.size(), points.size());
  require_spacing(spacing);
  const auto is_corner = [&](std::size_t i) { return labels[i] == Feature::Corner; };
  const auto is_labelled = [&](std::size_t i) {
    return labels[i] == Feature::Edge || is_corner(i);
  };
  const FiniteCloud labelled(points, execution, is_labelled);
  const FiniteCloud corner_points(points, execution, is_corner);
  const FiniteCloud true_corners(truth.corners, execution);
  const Segments edges(truth.edges);

  std::vector<double> to_edge(points.size());
  parallel_for(points.size(), sub_execution(execution, "labels", 0, 0.6), [&](std::size_t i) {
    to_edge[i] = is_finite(points[i]) ? std::sqrt(edges.squared_distance(points[i]))
                                      : std::numeric_limits<double>::quiet_NaN();
  });
  double right = 0;
  double of_edge = 0;
  double of_edge_labelled = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_labelled(i) && to_edge[i] <= edge_reach * spacing) ++right;
    if (to_edge[i] <= edge_point_reach * spacing) {
      ++of_edge;
      if (is_labelled(i)) ++of_edge_labelled;
    }
  }

  double all_length = 0;
  for (const auto& edge : truth.edges) all_length += length(edge);
  const double seen = parallel_sum(
      truth.edges.size(), sub_execution(execution, "edges", 0.6, 1), [&](std::size_t i) {
        return length_seen(truth.edges[i], labelled, edge_reach * spacing, spacing / 4);
      });

  const auto near = [&](const std::vector<Vec3>& places, const FiniteCloud& cloud) {
    return static_cast<double>(std::ranges::count_if(
        places, [&](const Vec3& p) { return has_within(cloud, p, corner_reach * spacing); }));
  };
  FeatureScore score;
  score.edge_labels = labelled.points().size();
  score.corner_labels = corner_points.points().size();
  score.edge_precision = share(right, static_cast<double>(score.edge_labels));
  score.edge_recall = share(seen, all_length);
  score.edge_point_recall = share(of_edge_labelled, of_edge);
  score.corner_precision =
      share(near(corner_points.points(), true_corners), static_cast<double>(score.corner_labels));
  score.corner_recall =
      share(near(truth.corners, corner_points), static_cast<double>(truth.corners.size()));
  return score;
}

DistanceError edge_error(Points points, const TriangleMesh& surface, const SharpFeatures& sharp,
                         double spacing, const Execution& execution) {
  require_spacing(spacing);
  const Segments edges(sharp.edges);
  const double reach = edge_zone * spacing;
  std::vector<std::uint8_t> near(points.size());
  parallel_for(points.size(), sub_execution(execution, "edges", 0, 0.7), [&](std::size_t i) {
    near[i] = is_finite(points[i]) && edges.squared_distance(points[i]) <= reach * reach ? 1 : 0;
  });
  std::vector<Vec3> zone;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (near[i] != 0) zone.push_back(points[i]);
  }
  return compare_to_surface(zone, surface, sub_execution(execution, "distances", 0.7, 1));
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/position_update.hpp"

#include "parallel.hpp"
#include "point_move.hpp"
#include "require.hpp"

namespace deburr {
namespace {

void validate(Points original, Points points, Normals normals, const Neighborhoods& neighborhoods,
              const PositionUpdateOptions& options) {
  require_size("original", original.size(), points.size());
  require_size("normals", normals.size(), points.size());
  require_size("neighborhoods", neighborhoods.size(), points.size());
  require(options.position_scale > 0, "position_update.position_scale", "> 0",
          options.position_scale);
  require(options.normal_scale > 0, "position_update.normal_scale", "> 0", options.normal_scale);
  require(options.step > 0 && options.step <= 1, "position_update.step", "in (0, 1]", options.step);
  require(options.feature_step > 0 && options.feature_step <= 1, "position_update.feature_step",
          "in (0, 1]", options.feature_step);
  require(options.max_move >= 0, "position_update.max_move", ">= 0", options.max_move);
}

}  // namespace

std::vector<Vec3> update_positions(Points original, Points points, Normals normals,
                                   const FeatureField& features, const Neighborhoods& neighborhoods,
                                   const PositionUpdateOptions& options,
                                   const Execution& execution) {
  validate(original, points, normals, neighborhoods, options);
  require_size("features.label", features.label.size(), points.size());
  require_size("features.direction", features.direction.size(), points.size());
  std::vector<Vec3> moved(points.size());
  parallel_for(points.size(), execution, [&](std::size_t i) {
    moved[i] = move_point(i, original[i], points, normals,
                          {features.label[i], features.direction[i]}, neighborhoods[i], options);
  });
  return moved;
}

FeatureField sweep_at_once(Points original, std::vector<Vec3>& points, Normals normals,
                           const Neighborhoods& neighborhoods,
                           const FeatureOptions& feature_options,
                           const PositionUpdateOptions& options, const Execution& execution) {
  validate(original, points, normals, neighborhoods, options);
  validate(feature_options);
  FeatureField field{std::vector<Feature>(points.size()), std::vector<Vec3>(points.size())};
  std::vector<Vec3> moved(points.size());
  parallel_for(points.size(), execution, [&](std::size_t i) {
    const PointClass c = classify_point(i, points, normals, neighborhoods[i], feature_options);
    moved[i] = move_point(i, original[i], points, normals, c, neighborhoods[i], options);
    field.label[i] = c.label;
    field.direction[i] = c.direction;
  });
  points = std::move(moved);
  return field;
}

FeatureField sweep_in_place(Points original, std::vector<Vec3>& points, Normals normals,
                            const Neighborhoods& neighborhoods,
                            const FeatureOptions& feature_options,
                            const PositionUpdateOptions& options,
                            std::span<const std::uint32_t> order, const Execution& execution) {
  validate(original, points, normals, neighborhoods, options);
  validate(feature_options);
  FeatureField field{std::vector<Feature>(points.size(), Feature::Isolated),
                     std::vector<Vec3>(points.size())};
  const std::size_t count = order.empty() ? points.size() : order.size();
  for (std::size_t at = 0; at < count; ++at) {
    if (at % block_size == 0) {
      check_cancelled(execution);
      if (execution.progress) {
        execution.progress({"", static_cast<double>(at) / static_cast<double>(count)});
      }
    }
    const std::size_t i = order.empty() ? at : order[at];
    require(i < points.size(), "order", "made of indices of points", i);
    const PointClass c = classify_point(i, points, normals, neighborhoods[i], feature_options);
    points[i] = move_point(i, original[i], points, normals, c, neighborhoods[i], options);
    field.label[i] = c.label;
    field.direction[i] = c.direction;
  }
  return field;
}

}  // namespace deburr

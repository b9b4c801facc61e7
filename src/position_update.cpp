// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/position_update.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "columns.hpp"
#include "move_batch.hpp"
#include "parallel.hpp"
#include "point_move.hpp"
#include "require.hpp"
#include "rows.hpp"
#include "sweep.hpp"

namespace deburr {
namespace {

void validate(Points original, Points points, Normals normals, std::size_t lists,
              const PositionUpdateOptions& options) {
  require_size("original", original.size(), points.size());
  require_size("normals", normals.size(), points.size());
  require_size("neighborhoods", lists, points.size());
  validate(options);
}

}  // namespace

void validate(const PositionUpdateOptions& options) {
  require(options.position_scale > 0, "position_update.position_scale", "> 0",
          options.position_scale);
  require(options.normal_scale > 0, "position_update.normal_scale", "> 0", options.normal_scale);
  require(options.step > 0 && options.step <= 1, "position_update.step", "in (0, 1]", options.step);
  require(options.feature_step > 0 && options.feature_step <= 1, "position_update.feature_step",
          "in (0, 1]", options.feature_step);
  require(options.max_move >= 0, "position_update.max_move", ">= 0", options.max_move);
}

std::vector<Vec3> update_positions(Points original, Points points, Normals normals,
                                   const FeatureField& features, const Neighborhoods& neighborhoods,
                                   const PositionUpdateOptions& options,
                                   const Execution& execution) {
  validate(original, points, normals, neighborhoods.size(), options);
  require_size("features.label", features.label.size(), points.size());
  require_size("features.direction", features.direction.size(), points.size());
  const std::vector<Row> point_rows = make_rows(points, execution);
  const std::vector<Row> normal_rows = make_rows(normals, execution);
  const Oriented cloud{point_rows.data(), normal_rows.data()};
  auto moved = make_column<Vec3>(points.size(), execution);
  parallel_for(points.size(), execution, [&](std::size_t i) {
    SurfaceSums sums;
    if (features.label[i] == Feature::Surface) {
      add_offsets(i, cloud, neighborhoods[i], options, 0, sums);
    }
    moved[i] = move_point(i, original[i], cloud, {features.label[i], features.direction[i]},
                          neighborhoods[i], sums, 0, options);
  });
  return moved;
}

namespace {

/// Moves batches of points in place: batch(k) gives the k-th of them.
template <typename Batch, typename Lists, typename Keep>
void sweep_batches(std::size_t count, const Batch& batch, const Lists& lists, Points original,
                   std::vector<Vec3>& points, Normals normals,
                   const FeatureOptions& feature_options, const PositionUpdateOptions& options,
                   NextNormals* next, const Keep& keep, const Execution& execution) {
  validate(original, points, normals, lists.size(), options);
  validate(feature_options);
  std::vector<Row> point_rows = make_rows(points, execution);
  const std::vector<Row> normal_rows = make_rows(normals, execution);
  if (next != nullptr) next->normals.resize(points.size());
  const Oriented cloud{point_rows.data(), normal_rows.data()};
  const MoveOptions how{feature_options, options, next != nullptr ? &next->filter : nullptr};
  MovedBatch moved;
  std::array<Vec3, lane_count> from{};
  constexpr std::size_t stretch = block_size / lane_count;
  NearBatch near;
  NearBatch upcoming;
  if (count > 0) upcoming.read(lists, batch(0));
  for (std::size_t k = 0; k < count; ++k) {
    check_cancelled(execution);
    if (k % stretch == 0 && execution.progress) {
      execution.progress({"", static_cast<double>(k) / static_cast<double>(count)});
    }
    std::swap(near, upcoming);
    const bool more = k + 1 < count;
    if (more) upcoming.read(lists, batch(k + 1));
    const std::span<const std::uint32_t> points_here = batch(k);
    for (std::size_t l = 0; l < points_here.size(); ++l) from[l] = original[points_here[l]];
    move_batch(points_here, cloud, near, from, how, more ? &upcoming : nullptr, moved);
    for (std::size_t l = 0; l < points_here.size(); ++l) {
      const std::uint32_t i = points_here[l];
      points[i] = moved.places[l];
      point_rows[i] = Row(moved.places[l]);
      if (next != nullptr) next->normals[i] = moved.normals[l];
      keep(i, moved.classes[l]);
    }
  }
}

FeatureField isolated(std::size_t count, const Execution& execution) {
  return {std::vector<Feature>(count, Feature::Isolated), make_column<Vec3>(count, execution)};
}

}  // namespace

FeatureField sweep_at_once(Points original, std::vector<Vec3>& points, Normals normals,
                           const Neighborhoods& neighborhoods,
                           const FeatureOptions& feature_options,
                           const PositionUpdateOptions& options, const Execution& execution) {
  validate(original, points, normals, neighborhoods.size(), options);
  validate(feature_options);
  const std::vector<Row> point_rows = make_rows(points, execution);
  const std::vector<Row> normal_rows = make_rows(normals, execution);
  const Oriented cloud{point_rows.data(), normal_rows.data()};
  const MoveOptions how{feature_options, options, nullptr};
  FeatureField field = isolated(points.size(), execution);
  parallel_blocks(points.size(), execution, [&](std::size_t begin, std::size_t end) {
    std::array<std::uint32_t, lane_count> batch{};
    std::array<Vec3, lane_count> from{};
    NearBatch near;
    MovedBatch moved;
    for (std::size_t first = begin; first < end; first += lane_count) {
      const std::size_t count = std::min(lane_count, end - first);
      for (std::size_t l = 0; l < count; ++l) {
        batch[l] = static_cast<std::uint32_t>(first + l);
        from[l] = original[first + l];
      }
      near.read(neighborhoods, {batch.data(), count});
      move_batch({batch.data(), count}, cloud, near, from, how, nullptr, moved);
      for (std::size_t l = 0; l < count; ++l) {
        points[first + l] = moved.places[l];
        field.label[first + l] = moved.classes[l].label;
        field.direction[first + l] = moved.classes[l].direction;
      }
    }
  });
  return field;
}

FeatureField sweep_in_place(Points original, std::vector<Vec3>& points, Normals normals,
                            const Neighborhoods& neighborhoods,
                            const FeatureOptions& feature_options,
                            const PositionUpdateOptions& options,
                            std::span<const std::uint32_t> order, const Execution& execution) {
  require(points.size() <= std::numeric_limits<std::uint32_t>::max(), "points", "fewer than 2^32",
          points.size());
  std::vector<std::uint32_t> by_index;
  if (order.empty()) {
    by_index.resize(points.size());
    std::iota(by_index.begin(), by_index.end(), 0U);
    order = by_index;
  }
  for (const std::uint32_t i : order) {
    require(i < points.size(), "order", "made of indices of points", i);
  }
  FeatureField field = isolated(points.size(), execution);
  sweep_batches(
      order.size(), [&](std::size_t at) { return order.subspan(at, 1); }, neighborhoods, original,
      points, normals, feature_options, options, nullptr,
      [&](std::size_t i, const PointClass& point_class) {
        field.label[i] = point_class.label;
        field.direction[i] = point_class.direction;
      },
      execution);
  return field;
}

std::vector<Feature> sweep_along(const SweepPlan& plan, Points original, std::vector<Vec3>& points,
                                 Normals normals, const NearLists& lists,
                                 const FeatureOptions& feature_options,
                                 const PositionUpdateOptions& options, NextNormals* next,
                                 const Execution& execution) {
  std::vector<Feature> labels(points.size(), Feature::Isolated);
  sweep_batches(
      plan.ends.size(),
      [&](std::size_t k) {
        const std::size_t begin = k > 0 ? plan.ends[k - 1] : 0;
        return std::span(plan.order).subspan(begin, plan.ends[k] - begin);
      },
      lists, original, points, normals, feature_options, options, next,
      [&](std::size_t i, const PointClass& point_class) { labels[i] = point_class.label; },
      execution);
  return labels;
}

}  // namespace deburr

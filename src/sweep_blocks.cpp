// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <optional>

#include "columns.hpp"
#include "move_batch.hpp"
#include "parallel.hpp"
#include "require.hpp"
#include "rows.hpp"
#include "sweep.hpp"

namespace deburr {
namespace {

/// What the points of one block see: themselves and their neighbours, next to each other in memory.
class View {
 public:
  /// Takes the rows of block `b`, whose points begin at `begin`.
  void take(const NearLists& lists, std::size_t b, Points points, Normals normals) {
    const std::size_t begin = b * lists.block();
    const std::size_t end = std::min(lists.size(), begin + lists.block());
    const std::optional<std::span<const std::uint32_t>> seen = lists.seen(b);
    points_.clear();
    normals_.clear();
    const auto add = [&](std::size_t i) {
      points_.emplace_back(points[i]);
      normals_.emplace_back(normals[i]);
    };
    if (seen) {
      for (const std::uint32_t i : *seen) add(i);
      own_ = static_cast<std::uint32_t>(points_.size());
      for (std::size_t i = begin; i < end; ++i) add(i);
    } else {  // so many that it is all of them
      for (std::size_t i = 0; i < points.size(); ++i) add(i);
      own_ = static_cast<std::uint32_t>(begin);
    }
  }
  [[nodiscard]] Oriented cloud() const { return {points_.data(), normals_.data()}; }
  /// Where the first point of the block is.
  [[nodiscard]] std::uint32_t own() const { return own_; }

 private:
  std::vector<Row> points_;
  std::vector<Row> normals_;
  std::uint32_t own_ = 0;
};

}  // namespace

std::vector<Feature> sweep_together(Points original, Points points, Normals normals,
                                    const NearLists& lists, const FeatureOptions& feature_options,
                                    const PositionUpdateOptions& options, std::span<Vec3> moved,
                                    NextNormals* next, const Execution& execution) {
  require_size("original", original.size(), points.size());
  require_size("normals", normals.size(), points.size());
  require_size("neighborhoods", lists.size(), points.size());
  require_size("moved", moved.size(), points.size());
  validate(options);
  validate(feature_options);
  if (next != nullptr) resize_column(next->normals, points.size(), execution);
  const MoveOptions how{feature_options, options, next != nullptr ? &next->filter : nullptr};
  std::vector<Feature> labels(points.size());
  const std::size_t blocks = (points.size() + lists.block() - 1) / lists.block();
  parallel_blocks<1>(blocks, execution, [&](std::size_t first, std::size_t last) {
    View view;
    NearBatch near;
    MovedBatch batch;
    std::array<Vec3, lane_count> from{};
    std::array<std::uint32_t, lane_count> rows{};
    for (std::size_t b = first; b < last; ++b) {
      const std::size_t begin = b * lists.block();
      const std::size_t end = std::min(points.size(), begin + lists.block());
      view.take(lists, b, points, normals);
      for (std::size_t i = begin; i < end; i += lane_count) {
        if ((i - begin) % block_size == 0) check_cancelled(execution);
        const std::size_t count = std::min(lane_count, end - i);
        for (std::size_t l = 0; l < count; ++l) {
          rows[l] = view.own() + static_cast<std::uint32_t>(i - begin + l);
          from[l] = original[i + l];
        }
        near.read_seen(lists, i, count);
        move_batch({rows.data(), count}, view.cloud(), near, from, how, nullptr, batch);
        for (std::size_t l = 0; l < count; ++l) {
          moved[i + l] = batch.places[l];
          labels[i + l] = batch.classes[l].label;
          if (next != nullptr) next->normals[i + l] = batch.normals[l];
        }
      }
    }
  });
  return labels;
}

}  // namespace deburr

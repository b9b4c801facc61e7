// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/normals.hpp"

#include <array>
#include <ranges>

#include "columns.hpp"
#include "lane_spectrum.hpp"
#include "lanes.hpp"
#include "parallel.hpp"
#include "require.hpp"
#include "sym3.hpp"
#include "unit.hpp"

namespace deburr {

namespace {

/// Matrices of points one after the other, whose axes are found for eight points at once.
struct AxisBatch {
  LanesSym3 matrices;
  std::array<std::size_t, lane_count> points{};
  std::size_t count = 0;

  void add(std::size_t point, const Sym3& matrix) {
    set_lane(matrices, count, matrix);
    points[count++] = point;
  }
};

/// Of each matrix, the eigenvector of the smallest eigenvalue.
DEBURR_MULTIVERSION
void find_least_axes(const AxisBatch& batch, std::array<Vec3, lane_count>& axes) {
  const LanesSpectrum s = spectrum(batch.matrices, 0);
  for (std::size_t l = 0; l < lane_count; ++l) axes[l] = lane(s.vectors[2], l);
}

/// Calls take(i, axis) for the points i in [0, n) for which give(i, matrix) fills in a matrix and
/// returns true.
template <typename Give, typename Take>
void for_least_axes(std::size_t n, const Execution& execution, const Give& give, const Take& take) {
  parallel_blocks(n, execution, [&](std::size_t begin, std::size_t end) {
    AxisBatch batch;
    std::array<Vec3, lane_count> axes;
    for (std::size_t i = begin; i < end; ++i) {
      Sym3 matrix;
      if (give(i, matrix)) batch.add(i, matrix);
      if (batch.count < (i + 1 == end ? 1 : lane_count)) continue;
      find_least_axes(batch, axes);
      for (std::size_t l = 0; l < batch.count; ++l) take(batch.points[l], axes[l]);
      batch.count = 0;
    }
  });
}

}  // namespace

std::vector<Vec3> estimate_normals(Points points, const Neighborhoods& neighborhoods,
                                   const Execution& execution) {
  require_size("neighborhoods", neighborhoods.size(), points.size());
  auto normals = make_column<Vec3>(points.size(), execution);
  const auto covariance = [&](std::size_t i, Sym3& matrix) {
    const auto neighbors = neighborhoods[i];
    if (neighbors.size() < 2) return false;
    // Centred on the point first: raw coordinates would lose the covariance at large offsets.
    Vec3 mean;
    for (const std::uint32_t j : neighbors | std::views::reverse) mean += points[j] - points[i];
    mean = (1.0 / static_cast<double>(neighbors.size())) * mean;
    for (const std::uint32_t j : neighbors | std::views::reverse) {
      matrix.add_outer(1, points[j] - points[i] - mean);
    }
    return matrix.trace() > 0;
  };
  for_least_axes(points.size(), execution, covariance,
                 [&](std::size_t i, const Vec3& axis) { normals[i] = axis; });
  return normals;
}

namespace {

/// Weighted moments, about a point, of its neighbours on the same side of the surface.
struct WeightedMoments {
  double count = 0;
  double total = 0;
  Vec3 sum;
  Sym3 outer;
};

DEBURR_MULTIVERSION
void add_weighted_moments(std::size_t i, Points points, Normals normals,
                          std::span<const std::uint32_t> neighbors,
                          const NormalRefitOptions& options, WeightedMoments& moments) {
  const double position_factor = -1 / (options.position_scale * options.position_scale);
  const double normal_factor = -1 / (options.normal_scale * options.normal_scale);
  const Lanes3 x = all_lanes(points[i]);
  const Lanes3 n = all_lanes(normals[i]);
  Lanes count{};
  Lanes total{};
  Lanes3 weighted;
  LanesSym3 outer;
  for (std::size_t k = 0; k < neighbors.size(); k += lane_count) {
    const Lanes3 d = load(points, neighbors, k) - x;
    const Lanes3 m = load(normals, neighbors, k);  // zero, so of no side, beyond the end
    const Lanes3 turn = m - n;
    const Lanes same_side = dot(n, m) > 0.0 ? all_lanes(1) : Lanes{};
    const Lanes w =
        same_side * exp_of_negative(position_factor * dot(d, d) + normal_factor * dot(turn, turn));
    count += same_side;
    total += w;
    weighted = weighted + w * d;
    outer.add_outer(w, d);
  }
  moments = {sum(count), sum(total), sum(weighted), sum(outer)};
}

}  // namespace

std::vector<Vec3> refit_normals(Points points, Normals normals, const Neighborhoods& neighborhoods,
                                const NormalRefitOptions& options, const Execution& execution) {
  require_size("normals", normals.size(), points.size());
  require_size("neighborhoods", neighborhoods.size(), points.size());
  require(options.position_scale > 0, "normal_refit.position_scale", "> 0", options.position_scale);
  require(options.normal_scale > 0, "normal_refit.normal_scale", "> 0", options.normal_scale);
  require(options.blend >= 0 && options.blend <= 1, "normal_refit.blend", "in [0, 1]",
          options.blend);

  std::vector<Vec3> refitted(normals.begin(), normals.end());
  const auto covariance = [&](std::size_t i, Sym3& matrix) {
    if (is_zero(normals[i])) return false;
    WeightedMoments moments;
    add_weighted_moments(i, points, normals, neighborhoods[i], options, moments);
    if (moments.count < 2) return false;
    // The point itself takes part with weight 1, at offset 0.
    matrix = moments.outer;
    matrix.add_outer(-1 / (moments.total + 1), moments.sum);
    return matrix.trace() > 0;
  };
  for_least_axes(points.size(), execution, covariance, [&](std::size_t i, const Vec3& axis) {
    const double side = dot(axis, normals[i]) < 0 ? -1 : 1;
    refitted[i] = unit(options.blend * side * axis + (1 - options.blend) * normals[i]);
  });
  return refitted;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/clean_metrics.hpp"

#include <cmath>
#include <limits>

#include "require.hpp"
#include "triangle_normal.hpp"
#include "unit.hpp"

namespace deburr {

OffsetError offset_error(Points points, Points clean, Normals normals, double far) {
  require_size("clean", clean.size(), points.size());
  require_size("normals", normals.size(), points.size());
  require(far > 0, "far", "> 0", far);
  OffsetError error;
  double sum = 0;
  double sum_of_squares = 0;
  double far_points = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& n = normals[i];
    if (!is_finite(points[i]) || !is_finite(clean[i]) || !is_finite(n) || is_zero(n)) continue;
    const Vec3 scaled = (1 / largest_coordinate(n)) * n;
    const double offset = dot(points[i] - clean[i], scaled) / norm(scaled);
    ++error.count;
    sum += offset;
    sum_of_squares += offset * offset;
    if (std::abs(offset) > far) ++far_points;
  }
  if (error.count > 0) {
    const auto count = static_cast<double>(error.count);
    error.mean = sum / count;
    error.rms = std::sqrt(sum_of_squares / count);
    error.far_share = far_points / count;
  }
  return error;
}

OutlierScore score_outliers(std::span<const std::uint8_t> flags,
                            std::span<const std::uint8_t> truth) {
  require_size("flags", flags.size(), truth.size());
  OutlierScore score;
  std::size_t right = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (flags[i] != 0) ++score.flagged;
    if (truth[i] != 0) ++score.outliers;
    if (flags[i] != 0 && truth[i] != 0) ++right;
  }
  const auto share = [&](std::size_t whole) {
    return whole > 0 ? static_cast<double>(right) / static_cast<double>(whole)
                     : std::numeric_limits<double>::quiet_NaN();
  };
  score.precision = share(score.flagged);
  score.recall = share(score.outliers);
  return score;
}

}  // namespace deburr

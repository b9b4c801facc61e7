// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "point_class.hpp"

#include <cmath>

#include "lanes.hpp"
#include "require.hpp"
#include "sym3.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Moments, about a point, of its neighbours with similar normals.
struct Moments {
  double count = 0;
  Vec3 sum;
  Sym3 outer;
};

/// A zero normal is similar to none, since rho is not negative.
DEBURR_MULTIVERSION
void add_moments(std::size_t i, Points points, Normals normals,
                 std::span<const std::uint32_t> neighbors, double rho, Moments& moments) {
  const Lanes3 x = all_lanes(points[i]);
  const Lanes3 n = all_lanes(normals[i]);
  Lanes count{};
  Lanes3 total;
  LanesSym3 outer;
  for (std::size_t k = 0; k < neighbors.size(); k += lane_count) {
    const Lanes similar = dot(n, load(normals, neighbors, k)) > rho ? all_lanes(1) : Lanes{};
    const Lanes3 d = load(points, neighbors, k) - x;
    count += similar;
    total = total + similar * d;
    outer.add_outer(similar, d);
  }
  moments = {sum(count), sum(total), sum(outer)};
}

}  // namespace

void validate(const FeatureOptions& options) {
  require(options.rho >= 0 && options.rho < 1, "features.rho", "in [0, 1)", options.rho);
  require(options.tau > 0 && options.tau < 1, "features.tau", "in (0, 1)", options.tau);
}

PointClass classify_point(std::size_t i, Points points, Normals normals,
                          std::span<const std::uint32_t> neighbors, const FeatureOptions& options) {
  Moments moments;
  add_moments(i, points, normals, neighbors, options.rho, moments);
  const double count = moments.count + 1;  // the point itself takes part, at offset 0
  Sym3 covariance = moments.outer;
  covariance.add_outer(-1 / count, moments.sum);
  covariance.scale(1 / count);
  if (moments.count == 0 || !(covariance.trace() > 0)) return {};

  const Spectrum s = spectrum(covariance, options.eigen_tolerance);
  const auto& l = s.values;
  const double threshold = options.tau * std::sqrt(l[0] * l[0] + l[1] * l[1] + l[2] * l[2]);
  if (l[2] < threshold && l[1] < threshold && l[0] > threshold) {
    return {Feature::Edge, s.vectors[0]};
  }
  if (l[2] < threshold && l[1] > threshold && l[0] > threshold) return {Feature::Surface, {}};
  return {Feature::Corner, {}};
}

}  // namespace deburr

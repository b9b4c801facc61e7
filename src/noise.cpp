// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "deburr/neighborhoods.hpp"
#include "parallel.hpp"
#include "sym3.hpp"

namespace deburr {
namespace {

/// Points in a plane fit besides its centre.
constexpr std::size_t fit_neighbors = 24;

/// A plane fitted to a point and its neighbours.
struct Fit {
  double variation;  ///< smallest eigenvalue over their sum: 0 is flat
  double residual;   ///< distance of the point from the plane
};

Fit fit_plane(Points points, std::size_t i, std::span<const std::uint32_t> neighbors) {
  const double count = static_cast<double>(neighbors.size()) + 1;
  Vec3 sum;
  for (const std::uint32_t j : neighbors) sum += points[j] - points[i];
  const Vec3 mean = (1 / count) * sum;
  Sym3 covariance;
  covariance.add_outer(1, mean);
  for (const std::uint32_t j : neighbors) covariance.add_outer(1, points[j] - points[i] - mean);
  // Also where squares overflow: a NaN would break the order of the fits.
  if (!(covariance.trace() > 0) || !std::isfinite(covariance.trace())) return {0, 0};
  const Spectrum s = spectrum(covariance);
  return {std::max(0.0, s.values[2]) / covariance.trace(), std::abs(dot(s.vectors[2], mean))};
}

}  // namespace

double estimate_noise(Points points, const Execution& execution) {
  std::vector<Vec3> finite;
  finite.reserve(points.size());
  std::copy_if(points.begin(), points.end(), std::back_inserter(finite), is_finite);
  if (finite.size() < 16) return 0;
  const Neighborhoods neighborhoods = find_neighbors(finite, {.max_count = fit_neighbors},
                                                     sub_execution(execution, "noise", 0, 0.8));
  std::vector<Fit> fits(finite.size());
  parallel_for(finite.size(), sub_execution(execution, "noise", 0.8, 1),
               [&](std::size_t i) { fits[i] = fit_plane(finite, i, neighborhoods[i]); });

  const auto half = fits.begin() + static_cast<std::ptrdiff_t>(fits.size() / 2);
  std::nth_element(fits.begin(), half, fits.end(), [](const Fit& a, const Fit& b) {
    return a.variation != b.variation ? a.variation < b.variation : a.residual < b.residual;
  });
  const auto middle = fits.begin() + (half - fits.begin()) / 2;
  std::nth_element(fits.begin(), middle, half,
                   [](const Fit& a, const Fit& b) { return a.residual < b.residual; });
  // A plane through n points takes 1/n of the variance at their centre with it.
  const double n = static_cast<double>(neighborhoods[0].size()) + 1;
  return 1.4826 * middle->residual / std::sqrt(1 - 1 / n);
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "noise_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "quantile.hpp"

namespace deburr {
namespace {

/// Fewer degrees of freedom do not count.
constexpr double fewest_freedom = 4;
/// From this whiteness on a patch counts as clear of features.
constexpr double white_enough = 0.9;

/// Variance of the noise from patches that are white, or, where they are few or do not agree with
/// `flat`, that.
double white_variance(const std::vector<double>& white, double share, double flat) {
  constexpr double fewest = 0.1;
  constexpr double most = 9;
  const double middle = quantile(white, 0.5);
  return share >= fewest && middle <= most * flat ? middle : flat;
}

}  // namespace

double SizeEstimate::resolution() const {
  constexpr double sufficient = 2.85;
  constexpr double small = 10;
  const double least = sufficient * (1 + small / static_cast<double>(count));
  return sigma > 0 ? reach / (least * sigma) : std::numeric_limits<double>::infinity();
}

SizeEstimate combine(std::span<const SurfacePatch> patches, std::size_t count,
                     const Flattest& flattest) {
  std::vector<double> flat;
  std::vector<double> white;
  std::vector<double> spacings;
  std::vector<double> reaches;
  for (const SurfacePatch& p : patches) {
    if (p.freedom < fewest_freedom) continue;
    flat.push_back(p.variance / chi_squared_share(flattest.quantile, p.freedom));
    if (p.whiteness >= white_enough) white.push_back(p.variance / chi_squared_share(0, p.freedom));
    spacings.push_back(p.spacing);
    reaches.push_back(p.reach);
  }
  SizeEstimate estimate{.count = count};
  if (flat.empty()) return estimate;
  estimate.white = static_cast<double>(white.size()) / static_cast<double>(flat.size());
  const double flat_variance = quantile(std::move(flat), flattest.share);
  const double whites = white_variance(white, estimate.white, flat_variance);
  // Two sheets that noise has mixed up look white, too, so that large patches rather need to be
  // flat.
  constexpr double smallest = 24;
  const double trust = std::min(1.0, smallest / static_cast<double>(count));
  if (flat_variance > 0) {
    estimate.sigma = std::sqrt(flat_variance) * std::pow(whites / flat_variance, 0.5 * trust);
  }
  estimate.spacing = quantile(std::move(spacings), 0.5);
  estimate.reach = quantile(std::move(reaches), 0.5);
  return estimate;
}

SizeEstimate between(const SizeEstimate& too_small, const SizeEstimate& large) {
  if (!(too_small.sigma > 0 && large.sigma > 0)) return large;
  const double from = std::log(too_small.resolution());
  const double to = std::log(large.resolution());
  if (!(from < 0 && to >= 0)) return large;
  const double share = -from / (to - from);
  SizeEstimate estimate = large;
  estimate.sigma = too_small.sigma * std::pow(large.sigma / too_small.sigma, share);
  estimate.reach = too_small.reach * std::pow(large.reach / too_small.reach, share);
  return estimate;
}

bool continues(const SizeEstimate& smaller, const SizeEstimate& larger) {
  constexpr double fewest = 0.15;
  constexpr double keeps = 0.6;
  constexpr double grows = 1.03;
  return larger.white >= std::max(fewest, keeps * smaller.white) &&
         larger.sigma <= grows * smaller.sigma;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "noise_levels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "parallel.hpp"
#include "quantile.hpp"

namespace deburr {
namespace {

/// From this ratio of its 90 % to its 10 % quantile on the noise differs from place to place. Of
/// noise that does not, estimates differ by a quarter.
constexpr double differs = 1.6;
/// Levels lie between these quantiles: beyond them are single places.
constexpr double lowest = 0.02;
constexpr double highest = 0.98;
/// And no further below the largest.
constexpr double most_ratio = 32;
/// The noise of a run over that of its level. Fits that expect too little noise break off, which
/// costs more than what too much of it costs; some of the points of a level have more.
constexpr double lift = 1.2;
/// Levels to either side of which points take part in a run. Those beyond one level have no share
/// in what comes of it, but keep the surface from ending where those do that have.
constexpr double margin = 1.3;

/// Where a value lies between levels, by products alone.
double by_level(const std::vector<double>& sigma, double value) {
  std::size_t i = 0;
  while (i + 1 < sigma.size() && value > sigma[i + 1]) ++i;
  const double above = std::clamp(value / sigma[i] - 1, 0.0, 1.0);
  return i + 1 < sigma.size() ? static_cast<double>(i) + above : static_cast<double>(i);
}

}  // namespace

NoiseLevels find_noise_levels(std::span<const double> local, double least) {
  NoiseLevels levels;
  const std::vector<double> all(local.begin(), local.end());
  if (all.empty() ||
      !(std::max(quantile(all, 0.9), least) > differs * std::max(quantile(all, 0.1), least))) {
    return levels;
  }
  const double high = std::max(quantile(all, highest), least);
  const double low = std::max({quantile(all, lowest), high / most_ratio, least});
  levels.sigma.push_back(low);
  while (2 * levels.sigma.back() < high * std::sqrt(2.0)) {
    levels.sigma.push_back(2 * levels.sigma.back());
  }
  levels.at.resize(local.size());
  for (std::size_t i = 0; i < local.size(); ++i) levels.at[i] = by_level(levels.sigma, local[i]);
  for (double& sigma : levels.sigma) sigma *= lift;
  return levels;
}

AutomaticResult denoise_at_levels(const AutomaticInput& input, const NoiseLevels& levels,
                                  double bound, double deviations, StageClock& clock,
                                  const Execution& execution) {
  const std::size_t n = input.points.size();
  const auto run = [&](const AutomaticInput& part, double sigma, const Execution& on) {
    AutomaticInput at_level = part;
    at_level.noise = sigma;
    at_level.max_move = bound > 0 ? bound : deviations * sigma;
    return denoise_automatically(at_level, clock, on);
  };
  AutomaticResult result;
  result.points.assign(n, Vec3{});
  result.normals.assign(n, Vec3{});
  result.labels.assign(n, Feature::Isolated);
  const double count = static_cast<double>(levels.sigma.size());
  for (std::size_t level = 0; level < levels.sigma.size(); ++level) {
    const auto here = static_cast<double>(level);
    std::vector<std::uint32_t> some;
    std::vector<Vec3> points;
    std::vector<Vec3> normals;
    for (std::uint32_t i = 0; i < n; ++i) {
      if (std::abs(levels.at[i] - here) > margin) continue;
      some.push_back(i);
      points.push_back(input.points[i]);
      if (!input.normals.empty()) normals.push_back(input.normals[i]);
    }
    // Noise that lies far apart leaves levels between without points.
    if (some.empty()) continue;
    AutomaticInput part = input;
    part.points = points;
    part.normals = normals;
    const AutomaticResult of_level =
        run(part, levels.sigma[level],
            sub_execution(execution, "denoise", here / count, (here + 1) / count));
    result.kept_normals = result.kept_normals || of_level.kept_normals;
    for (std::size_t k = 0; k < some.size(); ++k) {
      const std::uint32_t i = some[k];
      const double share = 1 - std::abs(levels.at[i] - here);
      if (!(share > 0)) continue;
      result.points[i] += share * of_level.points[k];
      // A point halfway belongs to the lower one.
      if (share > 0.5 || (share == 0.5 && levels.at[i] > here)) {
        result.normals[i] = of_level.normals[k];
        result.labels[i] = of_level.labels[k];
      }
    }
  }
  return result;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "two_sheets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "quadric_fit.hpp"

namespace deburr {
namespace {

constexpr std::size_t fewest = 32;
/// Of more points, evenly spaced ones will do.
constexpr std::size_t most = 512;
constexpr int rounds = 40;
/// The smaller sheet has at least this share of the points: fewer are outliers.
constexpr double least_share = 0.15;
/// Variance about two sheets, in parts of that about one: below is rounding.
constexpr double least_variance = 1e-8;

/// A mixture of two normal distributions with one variance.
struct Mixture {
  double low = 0, high = 0, share = 0.5, variance = 0;  ///< share: of the high one

  /// How much more likely a height is of the high one than of the low one, as a probability.
  [[nodiscard]] double high_share(double z) const {
    const double by = (0.5 * (low + high) - z) * (high - low) / variance;
    return share / (share + (1 - share) * std::exp(std::min(by, 500.0)));
  }
  [[nodiscard]] double log_density(double z) const {
    const double a = -0.5 * (z - low) * (z - low) / variance;
    const double b = -0.5 * (z - high) * (z - high) / variance;
    const double larger = std::max(a, b);
    return larger + std::log((1 - share) * std::exp(a - larger) + share * std::exp(b - larger)) -
           0.5 * std::log(variance);
  }
};

double mixing(std::span<const Vec3> points, const std::vector<double>& high, double share) {
  constexpr std::size_t asked = 64;
  const std::size_t step = std::max<std::size_t>(1, points.size() / asked);
  double differ = 0;
  double count = 0;
  for (std::size_t i = 0; i < points.size(); i += step) {
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t next = i;
    for (std::size_t j = 0; j < points.size(); ++j) {
      const double dx = points[j].x - points[i].x;
      const double dy = points[j].y - points[i].y;
      const double square = dx * dx + dy * dy;
      if (square < nearest && j != i) {
        nearest = square;
        next = j;
      }
    }
    differ += high[i] * (1 - high[next]) + (1 - high[i]) * high[next];
    ++count;
  }
  return differ / count / (2 * share * (1 - share));
}

/// As TwoSheets::valley, within a third of the gap around each place.
double valley(const std::vector<double>& heights, const Mixture& mix) {
  const double middle = 0.5 * (mix.low + mix.high);
  const double width = (mix.high - mix.low) / 6;
  double between = 0;
  double on = 0;
  for (const double z : heights) {
    if (std::abs(z - middle) < width) ++between;
    if (std::abs(z - mix.low) < width || std::abs(z - mix.high) < width) ++on;
  }
  return on > 0 ? 2 * between / on : 1;
}

}  // namespace

TwoSheets fit_two_sheets(std::span<const Vec3> all, double scale) {
  std::vector<Vec3> points;
  const std::size_t step = (all.size() + most - 1) / most;
  for (std::size_t i = 0; i < all.size(); i += step) points.push_back(all[i]);
  const std::size_t n = points.size();
  if (n < fewest) return {};
  const QuadricFit one = fit_quadric(points, scale);
  const double single = one.squares / static_cast<double>(n);
  if (!(single > 0)) return {};

  std::vector<Vec3> shifted(points);
  std::vector<double> high(n);
  HeightQuadric surface = one.surface;
  // Both halves of a normal distribution are this far from its middle.
  const double half = std::sqrt(single);
  Mixture mix{-0.8 * half, 0.8 * half, 0.5, 0.36 * single};
  double before = -std::numeric_limits<double>::infinity();
  double likelihood = before;
  for (int round = 0; round < rounds; ++round) {
    // Expectation, and for given memberships the offsets and the quadric in turn.
    likelihood = 0;
    double sum = 0;
    double low_sum = 0;
    double high_sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double z = points[i].z - surface.height(points[i].x, points[i].y);
      likelihood += mix.log_density(z);
      high[i] = mix.high_share(z);
      sum += high[i];
      high_sum += high[i] * z;
      low_sum += (1 - high[i]) * z;
    }
    if (likelihood - before < 1e-3 && round > 4) break;
    before = likelihood;
    const double total = static_cast<double>(n);
    mix.share = std::clamp(sum / total, least_share, 1 - least_share);
    if (!(sum > 0 && sum < total)) return {};
    mix.high = high_sum / sum;
    mix.low = low_sum / (total - sum);
    for (std::size_t i = 0; i < n; ++i) {
      shifted[i].z = points[i].z - (high[i] * mix.high + (1 - high[i]) * mix.low);
    }
    surface = fit_quadric(shifted, scale).surface;
    double squares = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double z = points[i].z - surface.height(points[i].x, points[i].y);
      squares +=
          high[i] * (z - mix.high) * (z - mix.high) + (1 - high[i]) * (z - mix.low) * (z - mix.low);
    }
    mix.variance = std::max(squares / total, least_variance * single);
  }
  TwoSheets two;
  constexpr double parameters = 7;
  const double total = static_cast<double>(n);
  two.gap = mix.high - mix.low;
  two.variance = mix.variance * total / (total - parameters);
  two.share = std::min(mix.share, 1 - mix.share);
  two.gain = likelihood - total * (-0.5 * std::log(single) - 0.5);
  two.mixing = mixing(points, high, mix.share);
  std::vector<double> heights(n);
  for (std::size_t i = 0; i < n; ++i) {
    heights[i] = points[i].z - surface.height(points[i].x, points[i].y);
  }
  two.valley = valley(heights, mix);
  return two;
}

}  // namespace deburr

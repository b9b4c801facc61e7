// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "noise_tails.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "parallel.hpp"
#include "quantile.hpp"
#include "surface_patch.hpp"

namespace deburr {
namespace {

/// Heights beyond this many standard deviations are far off: 1 % of normal ones.
constexpr double far = 2.5;
/// And this part of a patch's reach: what rounding leaves of no noise at all has no tails.
constexpr double least = 0.01;
/// Share of points far off, on either side, that is no longer normal noise.
constexpr double heavy = 0.065;

/// What is over one patch.
struct Column {
  double variance = 0;  ///< within the patch
  double count = 0;
  double two_sided = 0;  ///< twice the smaller of the numbers far above and far below
  double square = 0;     ///< mean of the squared heights
  double fourth = 0;     ///< mean of their fourth powers
  double limit = 0;      ///< how high and low it looks
};

Column look(PatchFitter& fitter, Vec3 place, std::size_t count, std::size_t wide, double sigma) {
  const SurfacePatch patch = fitter.fit(place, count);
  if (!(patch.freedom > 0)) return {};
  Column column;
  column.variance = patch.variance;
  double above = 0;
  double below = 0;
  const double bound = std::max(far * sigma, least * patch.reach);
  for (const double h : fitter.heights(wide)) {
    if (h > bound) ++above;
    if (h < -bound) ++below;
    column.square += h * h;
    column.fourth += h * h * h * h;
    ++column.count;
  }
  column.two_sided = 2 * std::min(above, below);
  column.square /= column.count;
  column.fourth /= column.count;
  column.limit = fitter.height_limit();
  return column;
}

/// Standard deviation over the patches that show the least noise, which lie clear of edges.
double pooled_sigma(std::vector<Column> columns) {
  std::ranges::sort(columns, {}, &Column::square);
  columns.resize(std::max<std::size_t>(1, 3 * columns.size() / 4));
  double square = 0;
  double fourth = 0;
  for (const Column& c : columns) {
    square += c.square;
    fourth += c.fourth;
  }
  const double n = static_cast<double>(columns.size());
  const double excess = std::clamp(fourth * n / (square * square) - 3, 0.0, 6.0);
  // The median over three quarters from below is the quantile 3/8 of all. The mean square of n
  // values spreads like chi^2 with fewer degrees of freedom where tails are heavy.
  constexpr double middle_quantile = -0.3186;
  const Column& middle = columns[columns.size() / 2];
  const double freedom = 2 * middle.count / (2 + excess);
  return std::sqrt(middle.square / chi_squared_share(middle_quantile, freedom));
}

}  // namespace

double with_tails(Points points, const KdTree& tree, std::span<const Vec3> places,
                  std::size_t count, double sigma, const Execution& execution) {
  constexpr std::size_t most_wide = 4096;
  constexpr std::size_t fewest_clouds = 12;
  double whole = sigma;
  for (std::size_t wide = 8 * count; wide <= most_wide && wide <= points.size() / fewest_clouds;
       wide *= 4) {
    std::vector<Column> columns(places.size());
    constexpr std::size_t block = 16;
    parallel_blocks<block>(places.size(), execution, [&](std::size_t begin, std::size_t end) {
      PatchFitter fitter(points, tree);
      for (std::size_t i = begin; i < end; ++i) {
        columns[i] = look(fitter, places[i], count, wide, sigma);
      }
    });
    std::erase_if(columns, [](const Column& c) { return !(c.count > 0); });
    if (columns.empty()) break;
    std::ranges::sort(columns, {}, &Column::variance);
    columns.resize((columns.size() + 1) / 2);
    double all = 0;
    double off = 0;
    double limit = 0;
    for (const Column& c : columns) {
      all += c.count;
      off += c.two_sided;
      limit += c.limit / static_cast<double>(columns.size());
    }
    if (off <= heavy * all) break;
    whole = std::max(sigma, pooled_sigma(columns));
    if (far * whole < limit) break;
  }
  return whole;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "noise_sheets.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "parallel.hpp"
#include "quantile.hpp"
#include "surface_patch.hpp"
#include "two_sheets.hpp"

namespace deburr {
namespace {

/// Points in a patch: fewer neither tell which way sheets lie that are as far apart as points are,
/// nor two normal distributions from one.
constexpr std::size_t fewest_points = 128;
constexpr std::size_t most_points = 8192;
constexpr std::size_t fewest_patches = 5;  ///< no patch holds more than this share of the cloud
constexpr double growth = std::numbers::sqrt2;
/// Sizes that are looked at.
constexpr int sizes = 4;
/// Two sheets lie over each other, and not side by side, from this mixing on.
constexpr double mixed = 0.7;
/// What is closer than this, in standard deviations, cannot be told from one sheet.
constexpr double apart = 2.5;
/// A patch counts for two sheets if they are so much likelier than one, as a logarithm.
constexpr double likely = 5;
/// They are evident if the mean over all patches is this. Noise of one sheet reaches 4. A patch
/// counts for no more than `most_gain`, so that nearly half of them must have two sheets: where
/// fewer have, the others tell the noise.
constexpr double evident = 7.5;
constexpr double most_gain = 20;
/// Below this mean, what is not evident in a patch of the first size is not in larger ones.
constexpr double hopeless = 3;
/// Between two sheets there are fewer points than on them, by this at least.
/// Noise that is as likely everywhere within bounds has 0.65, sheets 3.5 standard deviations apart
/// 0.4.
constexpr double deepest = 0.5;
/// A change of sigma by less is not worth it.
constexpr double less = 0.9;

/// How much speaks for two sheets.
double gain(const TwoSheets& two) {
  const bool over = two.mixing > mixed && two.gap * two.gap > apart * apart * two.variance;
  return over ? std::min(two.gain, most_gain) : 0;
}

/// What the patches that can be fitted show.
std::vector<TwoSheets> look(Points points, const KdTree& tree, std::span<const Vec3> places,
                            std::size_t count, const Execution& execution) {
  std::vector<TwoSheets> looks(places.size());
  std::vector<std::uint8_t> fitted(places.size(), 0);
  constexpr std::size_t block = 8;
  parallel_blocks<block>(places.size(), execution, [&](std::size_t begin, std::size_t end) {
    PatchFitter fitter(points, tree);
    for (std::size_t i = begin; i < end; ++i) {
      Vec3 place = places[i];
      const SurfacePatch patch = fitter.fit(place, count);
      if (!(patch.freedom > 0)) continue;
      looks[i] = fit_two_sheets(fitter.members(), patch.reach);
      fitted[i] = 1;
    }
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    if (fitted[i] != 0) looks[kept++] = looks[i];
  }
  looks.resize(kept);
  return looks;
}

double median(const std::vector<TwoSheets>& looks, double TwoSheets::*value) {
  std::vector<double> values;
  values.reserve(looks.size());
  for (const TwoSheets& two : looks) values.push_back(two.*value);
  return quantile(std::move(values), 0.5);
}

}  // namespace

CloseSheets find_close_sheets(Points points, const KdTree& tree, std::span<const Vec3> places,
                              std::size_t resolving, double sigma, const Execution& execution) {
  double size = static_cast<double>(std::max(fewest_points, resolving));
  for (int looked = 0; looked < sizes; ++looked, size *= growth) {
    const auto count = static_cast<std::size_t>(size);
    if (count > most_points || count > points.size() / fewest_patches) break;
    std::vector<TwoSheets> looks = look(points, tree, places, count, execution);
    if (looks.empty()) break;
    double mean = 0;
    for (const TwoSheets& two : looks) mean += gain(two) / static_cast<double>(looks.size());
    if (mean < hopeless) break;
    if (mean < evident) continue;
    std::erase_if(looks, [](const TwoSheets& two) { return gain(two) < likely; });
    if (!(median(looks, &TwoSheets::valley) < deepest)) break;
    CloseSheets close;
    close.sigma = std::sqrt(median(looks, &TwoSheets::variance));
    close.gap = median(looks, &TwoSheets::gap);
    close.found = close.sigma < less * sigma;
    return close;
  }
  return {};
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "surer_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace deburr {
namespace {

constexpr double most_ratio = 3;   ///< of the variance of a sure sheet to the lower quartile
constexpr double most_noises = 3;  ///< from a point to a sheet that it may be of

}  // namespace

std::uint32_t surer_sheet(const Vec3& point, std::uint32_t own, std::span<const Found> near,
                          std::span<const Sheet> sheets, double noise,
                          std::vector<double>& variances) {
  variances.clear();
  for (const Found& f : near) {
    if (sheets[f.index].valid) variances.push_back(sheets[f.index].variance);
  }
  if (variances.empty()) return own;
  const auto quarter = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 4);
  std::ranges::nth_element(variances, quarter);
  const double most = most_ratio * *quarter;
  if (own != KdTree::no_point && sheets[own].valid && sheets[own].variance <= most) return own;
  for (const Found& f : near) {
    const Sheet& sheet = sheets[f.index];
    if (!sheet.valid || sheet.variance > most) continue;
    if (std::abs(sheet.meet(point).distance) <= most_noises * noise) return f.index;
  }
  return own;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "surer_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace deburr {
namespace {

constexpr double most_ratio = 3;   ///< of the variance of a sure sheet to the lower quartile
constexpr double most_noises = 3;  ///< from a point to a sheet that it may be of

/// Tells which sheets are sure. None needs the quartile itself: a variance is at most so many times
/// that if no more than a quarter of all are below its so manyth part.
class Sureness {
 public:
  Sureness(std::span<const Found> near, std::span<const PackedSheet> sheets)
      : near_(near), sheets_(sheets) {}

  [[nodiscard]] bool is_sure(const PackedSheet& sheet) {
    const double certainty = sheet.certainty;
    // What is as certain as a sure one is sure, and none is that is no more certain than an unsure.
    if (certainty >= sure_) return true;
    if (certainty <= unsure_) return false;
    const double far_more = std::sqrt(most_ratio) * certainty;
    std::size_t surer = 0;
    for (const Found& f : near_) surer += sheets_[f.index].certainty > far_more ? 1U : 0U;
    const bool sure = surer <= near_.size() / 4;
    (sure ? sure_ : unsure_) = certainty;
    return sure;
  }

 private:
  std::span<const Found> near_;
  std::span<const PackedSheet> sheets_;
  double sure_ = std::numeric_limits<double>::infinity();
  double unsure_ = 0;
};

}  // namespace

std::uint32_t surer_sheet(const Vec3& point, std::uint32_t own, std::span<const Found> near,
                          std::span<const PackedSheet> sheets, double noise) {
  Sureness sureness(near, sheets);
  if (own != KdTree::no_point && sureness.is_sure(sheets[own])) return own;
  const auto stands_in = std::ranges::find_if(near, [&](const Found& f) {
    const PackedSheet& sheet = sheets[f.index];
    return std::abs(sheet.meet(point).distance) <= most_noises * noise && sureness.is_sure(sheet);
  });
  return stands_in != near.end() ? stands_in->index : own;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "near_duplicates.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "kd_tree.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Distance of points that count as one, in spacings.
constexpr double near = 1e-3;

/// Of ordinary points at random, one in a million has another one as near as that. Some are left
/// alone, so that no cloud changes for the sake of chance.
constexpr std::size_t rare = 1000;

constexpr std::size_t fewest_points = 64;
constexpr std::size_t most_samples = 4096;

/// Neighbours in the sample that tell the spacing: more than a point has copies.
constexpr std::size_t neighbors = 8;

/// Near points of one that are looked at.
constexpr std::size_t copies = 8;

/// How near is near, from place to place. A sample of every so many points along the curve is as
/// dense, in proportion, as all are; copies mostly stand next to each other there and are passed
/// over.
class Nearness {
 public:
  Nearness(Points points, const Execution& execution)
      : step_((points.size() + most_samples - 1) / most_samples),
        sample_(every(points, step_)),
        tree_(sample_, execution) {
    std::vector<double> all(sample_.size());
    parallel_for(sample_.size(), execution, [&](std::size_t i) { all[i] = at(sample_[i]); });
    const auto half = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), half, all.end());
    typical_ = *half;
  }

  [[nodiscard]] double typical() const { return typical_; }

  /// Not more than what is typical: single points off the surface have no say.
  [[nodiscard]] double at_most_typical(const Vec3& place) const {
    return std::min(typical_, at(place));
  }

 private:
  static std::vector<Vec3> every(Points points, std::size_t step) {
    std::vector<Vec3> some;
    for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
    return some;
  }

  [[nodiscard]] double at(const Vec3& place) const {
    thread_local std::vector<Found> found;
    tree_.nearest_to(place, neighbors, infinity, found);
    // A disc of that radius holds as many points of a surface.
    const double points_in_disc = static_cast<double>(neighbors * step_);
    return near * std::sqrt(found.back().squared_distance * std::numbers::pi / points_in_disc);
  }

  std::size_t step_;
  std::vector<Vec3> sample_;
  KdTree tree_;
  double typical_ = 0;
};

/// Whether enough points have one next to them along the curve that is near. Few near pairs are
/// parted by the curve.
bool has_near_duplicates(Points points, double distance) {
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (squared_norm(points[i] - points[i - 1]) <= distance * distance) ++pairs;
  }
  return pairs * rare >= points.size();
}

}  // namespace

std::vector<std::uint32_t> find_near_duplicates(Points points, const Execution& execution) {
  if (points.size() < fewest_points) return {};
  const Execution quiet = without_progress(execution);
  const Nearness nearness(points, quiet);
  if (!has_near_duplicates(points, nearness.typical())) return {};

  const KdTree tree(points, quiet);
  std::vector<std::vector<std::uint32_t>> later(points.size());
  parallel_for(points.size(), quiet, [&](std::size_t i) {
    thread_local std::vector<Found> found;
    const auto point = static_cast<std::uint32_t>(i);
    const double typical = nearness.typical();
    tree.nearest(point, copies, typical * typical, found);
    if (found.empty()) return;
    const double here = nearness.at_most_typical(points[i]);
    for (const Found& f : found) {
      if (f.index > point && f.squared_distance <= here * here) later[i].push_back(f.index);
    }
  });
  // Along the curve, which depends on the positions alone. A point stands for others or has another
  // one, not both, so that chains of points do not become one.
  std::vector<std::uint32_t> standing(points.size());
  std::iota(standing.begin(), standing.end(), 0U);
  bool any = false;
  CancelWatch watch(quiet);
  for (std::uint32_t i = 0; i < standing.size(); ++i) {
    watch();
    if (standing[i] != i) continue;
    for (const std::uint32_t j : later[i]) {
      if (standing[j] == j) standing[j] = i;
      any = true;
    }
  }
  if (!any) standing.clear();
  return standing;
}

}  // namespace deburr

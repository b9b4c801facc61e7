// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outlier_knots.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "parallel.hpp"

namespace deburr {
namespace {

/// Radius of a patch in standard deviations of the noise: wanted, and least to be believed.
constexpr double wanted_radius = 4.5;
constexpr double least_radius = 4;

constexpr std::size_t trial_knots = 32;
constexpr std::size_t trial_places = 512;
constexpr std::size_t places_of_block = 16;
constexpr std::size_t place_points = 4;  ///< whose distances from the patch are taken

/// Knots in a patch: without noise, where the fewest follow the surface best, and with it.
constexpr double fewest_exact = 20;
constexpr double fewest = 36;
constexpr double most = 48;

/// Noise in spacings, roughly, that fewer knots suffice for.
constexpr double little_noise = 0.14;

/// Radius of the grid over what most patches need.
constexpr double grid_margin = 1.25;

/// A thinner copy than this says nothing.
constexpr std::size_t fewest_thinned = 1000;

}  // namespace

std::uint32_t middle_point(Points points, std::span<const std::uint32_t> ids) {
  const Vec3& origin = points[ids[0]];
  Vec3 sum;
  for (const std::uint32_t i : ids) sum += points[i] - origin;
  const Vec3 mean = origin + (1 / static_cast<double>(ids.size())) * sum;
  double least = std::numeric_limits<double>::infinity();
  // Both of two are as near to their mean, up to rounding.
  constexpr double alike = 1 + 1e-9;
  for (const std::uint32_t i : ids) least = std::min(least, squared_norm(points[i] - mean));
  std::uint32_t middle = no_point;
  for (const std::uint32_t i : ids) {
    if (squared_norm(points[i] - mean) <= alike * least) middle = std::min(middle, i);
  }
  return middle;
}

double spread(std::span<double> distances) {
  if (distances.empty()) return 0;
  const auto at = distances.begin() + static_cast<std::ptrdiff_t>(4 * distances.size() / 5);
  std::nth_element(distances.begin(), at, distances.end());
  return *at / 1.2816;
}

Knots::Knots(const SomePoints& points, const Execution& execution)
    : some_(points), points_(points.points()), count_(trial_knots) {
  // How many trials it takes is not known, so that they tell no progress.
  const Execution quiet = without_progress(execution);
  Trial trial = try_out(quiet);
  while (trial.radius < least_radius * trial.noise && points_.size() / group_ > fewest_thinned) {
    thin(4 * group_, quiet);
    trial = try_out(quiet);
  }
  // The number of points within a radius grows with its square.
  const auto per_knot = [&] {
    return static_cast<double>(points_.size()) /
           static_cast<double>(group_ == 1 ? points_.size() : thinned_.size());
  };
  const double ratio = wanted_radius * trial.noise / trial.radius;
  // Distances beyond all numbers tell nothing of the radius.
  const double growth = std::isfinite(ratio * ratio) ? ratio * ratio : 1;
  const double points_wanted = growth * static_cast<double>(trial_knots) * per_knot();
  std::size_t group = 1;
  while (points_wanted > most * static_cast<double>(group)) group *= 2;
  const double in_trial = static_cast<double>(trial_knots) * per_knot();
  if (group != group_) thin(group, quiet);
  const double little = wanted_radius * little_noise;
  const double least = points_wanted < 3.14 * little * little ? fewest_exact : fewest;
  count_ = static_cast<std::size_t>(std::clamp(points_wanted / per_knot(), least, most));
  const double usual =
      trial.radius * std::sqrt(static_cast<double>(count_ + 1) * per_knot() / in_trial);
  grid_ =
      CellGrid::make(group_ == 1 ? points_ : Points(thinned_), grid_margin * usual, count_, quiet);
}

/// Keeps of each group of points the one nearest to their mean.
void Knots::thin(std::size_t group, const Execution& execution) {
  group_ = group;
  thinned_.clear();
  thinned_tree_.reset();
  if (group == 1) return;
  const std::span<const std::uint32_t> order = some_.order();
  const std::vector<std::uint32_t> begins = some_.groups(group);
  thinned_.resize(begins.size() - 1);
  parallel_for(thinned_.size(), execution, [&](std::size_t g) {
    const auto members = order.subspan(begins[g], begins[g + 1] - begins[g]);
    thinned_[g] = points_[middle_point(points_, members)];
  });
  thinned_tree_ = std::make_unique<KdTree>(thinned_, execution);
}

/// The nearest knots to a place, in no particular order that is yet always the same.
void Knots::find_near(const Vec3& at, std::size_t count, std::vector<Found>& found) const {
  if (grid_) {
    grid_->within_of(at, found);
    if (found.size() >= count) {
      const auto last = found.begin() + static_cast<std::ptrdiff_t>(count) - 1;
      std::nth_element(found.begin(), last, found.end());
      found.resize(count);
      return;
    }
  }
  if (group_ == 1) return some_.nearest_to(at, count, found);
  thinned_tree_->nearest_to(at, count, std::numeric_limits<double>::infinity(), found);
}

Patch Knots::patch_at(const Vec3& at, std::uint32_t but, std::vector<Vec3>& near) const {
  thread_local std::vector<Found> found;
  const Points knots = group_ == 1 ? points_ : Points(thinned_);
  if (but == no_point) {
    find_near(at, count_, found);
  } else {
    find_near(at, count_ + 1, found);
    auto out = std::ranges::find_if(found, [&](const Found& f) {
      return group_ == 1 ? f.index == but : knots[f.index] == points_[but];
    });
    if (out == found.end() && found.size() > count_)
      out = std::ranges::max_element(found, std::less{});
    if (out != found.end()) found.erase(out);
  }
  near.clear();
  for (const Found& f : found) near.push_back(knots[f.index]);
  return fit_patch(near, at);
}

Knots::Trial Knots::try_out(const Execution& execution) const {
  const std::span<const std::uint32_t> order = some_.order();
  const std::vector<std::uint32_t> begins =
      some_.groups(std::max(order.size() / trial_places, 3 * place_points));
  const std::size_t places = begins.size() - 1;
  std::vector<double> radii(places);
  std::vector<double> distances(place_points * places);
  parallel_for<places_of_block>(places, execution, [&](std::size_t s) {
    // The first points of a range are of one leaf, and near to each other.
    const auto first =
        order.subspan(begins[s], std::min<std::size_t>(place_points, begins[s + 1] - begins[s]));
    const Vec3& middle = points_[middle_point(points_, first)];
    thread_local std::vector<Vec3> near;
    const Patch rough = patch_at(middle, no_point, near);
    const Patch patch = patch_at(foot_on(rough, middle).at, no_point, near);
    radii[s] = patch.radius;
    for (std::size_t k = 0; k < place_points; ++k) {
      const Vec3& point = points_[first[k % first.size()]];
      distances[place_points * s + k] = foot_on(patch, point).distance;
    }
  });
  Trial trial;
  trial.noise = spread(distances);
  const auto half = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), half, radii.end());
  trial.radius = *half;
  return trial;
}

}  // namespace deburr

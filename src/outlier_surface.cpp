// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outlier_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "columns.hpp"
#include "halves.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Knots in a cell, at most: as a share of those in a patch, which must reach over it.
constexpr double cell_share = 0.36;
constexpr double fewest_in_cell = 10;

/// Cells around a place whose noise has a say in that there. With fewer, chance in it alone gives
/// the scores a long tail.
constexpr std::size_t cells_around = 25;

/// The more noise, the fewer cells there are, and the more points in each.
constexpr std::size_t cells_of_block = 32;

/// Cells next to each other that share it, at most.
constexpr std::size_t cells_together = 4;

/// Least noise, in radii of a patch: patches follow edges no better than that.
constexpr double least_noise = 0.08;

/// Cell centres are no farther than about one radius from any surface: beyond three there is none.
constexpr double far_in_radii = 3;

/// Whether the knots around a foot lie all to one side of it and apart, in the plane of the patch:
/// then it is past the end of an open surface.
bool is_past_the_end(const Patch& patch, const Vec3& foot, std::span<const Vec3> knots) {
  Vec3 sum;
  double nearest = infinity;
  double farthest = 0;
  for (const Vec3& knot : knots) {
    const double u = dot(knot - foot, patch.u);
    const double v = dot(knot - foot, patch.v);
    nearest = std::min(nearest, u * u + v * v);
    farthest = std::max(farthest, u * u + v * v);
    sum += Vec3{u, v, 0};
  }
  const double count = static_cast<double>(knots.size());
  // Knots that fill a disc have the spacing sqrt(pi / count) radii.
  const double spacing = std::numbers::pi / count * patch.radius * patch.radius;
  constexpr double apart = 2.5;
  constexpr double aside = 0.5;
  return nearest > apart * apart * spacing &&
         squared_norm((1 / count) * sum) > aside * aside * farthest;
}

}  // namespace

RoughSurface::RoughSurface(const SomePoints& points, const Execution& execution)
    : some_(points), points_(points.points()), knots_(points, execution) {
  fit_cells(sub_execution(execution, "", 0, 0.9));
  smooth_noise(sub_execution(execution, "", 0.9, 1));
}

void RoughSurface::fit_cells(const Execution& execution) {
  const std::span<const std::uint32_t> order = some_.order();
  const auto cell_knots = static_cast<std::size_t>(
      std::max(fewest_in_cell, cell_share * static_cast<double>(knots_.per_patch())));
  const std::vector<std::uint32_t> begins = some_.groups(cell_knots * knots_.group());
  const Execution quiet = without_progress(execution);
  resize_column(cells_, begins.size() - 1, quiet);
  resize_column(centers_, cells_.size(), quiet);
  resize_column(cell_, points_.size(), quiet);
  resize_column(distance_, points_.size(), quiet);
  parallel_for<cells_of_block>(cells_.size(), execution, [&](std::size_t c) {
    Cell& cell = cells_[c];
    const auto members = order.subspan(begins[c], begins[c + 1] - begins[c]);
    const Vec3& middle = points_[middle_point(points_, members)];
    thread_local std::vector<Vec3> near;
    thread_local std::vector<double> distances;
    cell.patch = knots_.patch_at(middle, no_point, near);
    distances.clear();
    for (const std::uint32_t i : members) {
      const Foot foot = foot_on(cell.patch, points_[i]);
      cell_[i] = static_cast<std::uint32_t>(c);
      distance_[i] = foot.distance;
      if (foot.aside > cell.patch.radius) distance_[i] = infinity;
      distances.push_back(foot.distance);
    }
    cell.noise = spread(distances);
    centers_[c] = foot_on(cell.patch, middle).at;
  });
  center_tree_ = std::make_unique<KdTree>(centers_, execution);
}

/// The median over each cell and those around it, which a few odd cells do not sway.
void RoughSurface::smooth_noise(const Execution& execution) {
  const std::vector<std::uint32_t> begins = halves(cells_.size(), cells_together);
  std::vector<double> smooth(begins.size() - 1);
  parallel_for(smooth.size(), execution, [&](std::size_t g) {
    thread_local std::vector<Found> found;
    thread_local std::vector<double> near;
    center_tree_->nearest_to(centers_[begins[g]], cells_around, infinity, found);
    near.clear();
    for (const Found& f : found) near.push_back(cells_[f.index].noise);
    const auto half = near.begin() + static_cast<std::ptrdiff_t>(near.size() / 2);
    std::nth_element(near.begin(), half, near.end());
    smooth[g] = *half;
  });
  for (std::size_t g = 0; g < smooth.size(); ++g) {
    for (std::uint32_t c = begins[g]; c < begins[g + 1]; ++c) cells_[c].noise = smooth[g];
  }
}

std::uint32_t RoughSurface::nearest_cell(const Vec3& at, double& squared_distance) const {
  const Found nearest = center_tree_->nearest_to(at);
  squared_distance = nearest.squared_distance;
  // Between places whose distance is beyond all numbers none is the nearest.
  return std::isfinite(squared_distance) ? nearest.index : 0;
}

double RoughSurface::rough_score(std::uint32_t point) const {
  std::uint32_t c = cell_[point];
  double distance = distance_[point];
  // The corners of its cell may be beyond the patch, and nearer to another.
  if (distance == infinity) {
    double unused = 0;
    c = nearest_cell(points_[point], unused);
    const Foot foot = foot_on(cells_[c].patch, points_[point]);
    if (foot.aside <= cells_[c].patch.radius) distance = foot.distance;
  }
  const Cell& cell = cells_[c];
  return distance / std::max({cell.noise, least_noise * cell.patch.radius, cell.patch.spread});
}

double RoughSurface::fine_score(const Vec3& at, std::uint32_t self) const {
  thread_local std::vector<Vec3> near;
  // Not always its own cell, whose patch may be far off its corners.
  double squared_distance = 0;
  const std::uint32_t nearest = nearest_cell(at, squared_distance);
  const Cell& cell = cells_[nearest];
  const double far = far_in_radii * cell.patch.radius;
  if (squared_distance > far * far) return infinity;
  const Foot rough = foot_on(cell.patch, at);
  // Far outside a patch its curvature means nothing. One of the points has others around it.
  const Vec3& outside = self == no_point ? centers_[nearest] : at;
  const Vec3 around = rough.aside <= cell.patch.radius ? rough.at : outside;
  const Patch patch = knots_.patch_at(around, self, near);
  const Foot foot = foot_on(patch, at);
  if (is_past_the_end(patch, foot.at, near)) return infinity;
  return foot.distance / std::max({cell.noise, least_noise * patch.radius, patch.spread});
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sym3.hpp"

namespace deburr {
namespace {

/// Half the height of the cylinder, in standard deviations of what is in it. Cutting the tails off
/// there takes 0.6 % of a normal distribution's variance.
constexpr double window = 3.5;
/// Bounds of half the height, in radii of the ball that the cylinder is inscribed in.
constexpr double lowest = 0.5;
constexpr double highest = 0.8;

/// The frame at the foot of `place` on a quadric over `frame`, along the normal there.
Frame foot(const Frame& frame, const Quadric& surface, const Vec3& place) {
  const Vec3 at = frame.local(place);
  const Vec3 normal = frame.w - surface.slope_x(at.x, at.y) * frame.u -
                      surface.slope_y(at.x, at.y) * frame.v;
  const Vec3 origin = place + (surface.height(at.x, at.y) - at.z) * frame.w;
  return frame_along(origin, (1 / norm(normal)) * normal);
}

}  // namespace

void PatchFitter::find(const Vec3& place, std::size_t count) {
  tree_.nearest(place, count, found_);
  reach_ = found_.empty() ? 0 : std::sqrt(found_.back().squared_distance);
}

Frame PatchFitter::principal_frame(const Vec3& place) const {
  Vec3 sum;
  for (const Found& f : found_) sum += points_[f.index] - place;
  const Vec3 mean = (1 / static_cast<double>(found_.size())) * sum;
  Sym3 covariance;
  for (const Found& f : found_) covariance.add_outer(1, points_[f.index] - place - mean);
  return frame_along(place + mean, spectrum(covariance).vectors[2]);
}

QuadricFit PatchFitter::fit_all(const Frame& frame) {
  local_.clear();
  for (const Found& f : found_) local_.push_back(frame.local(points_[f.index]));
  return fit_quadric(local_, reach_);
}

QuadricFit PatchFitter::fit_cylinder(const Frame& frame, double radius, double height) {
  local_.clear();
  for (const Found& f : found_) {
    const Vec3 p = frame.local(points_[f.index]);
    if (std::abs(p.z) <= height && p.x * p.x + p.y * p.y <= radius * radius) local_.push_back(p);
  }
  return fit_quadric(local_, reach_);
}

SurfacePatch PatchFitter::fit(Vec3& place, std::size_t count) {
  find(place, count);
  // Also where squares overflow.
  if (!(reach_ > 0) || !std::isfinite(reach_)) return {};
  Frame frame = principal_frame(place);
  QuadricFit fit = fit_all(frame);
  SurfacePatch patch;
  // The ball cuts off points by their noise, the cylinder only by their place on the surface. Its
  // axis comes from a fit, and a second round takes out the tilt of the first.
  for (int round = 0; round < 2; ++round) {
    frame = foot(frame, fit.surface, place);
    if (!is_finite(frame.origin) || !is_finite(frame.w)) return {};
    constexpr double off = 0.15;
    if (norm(frame.origin - place) > off * reach_) find(frame.origin, count);
    place = frame.origin;
    const double height =
        std::clamp(window * std::sqrt(fit.variance()), lowest * reach_, highest * reach_);
    const double radius = std::sqrt(reach_ * reach_ - height * height);
    fit = fit_cylinder(frame, radius, height);
    if (!(fit.freedom() > 0)) return {};
    patch = {fit.variance(), fit.freedom(), reach_,
             radius * std::sqrt(std::numbers::pi / static_cast<double>(fit.count))};
  }
  return patch;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_patch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Variance of a normal distribution of which only what lies within +-bound was seen, from the
/// `variance` of that.
double whole_variance(double variance, double bound) {
  double whole = variance;
  for (int step = 0; step < 4 && whole > 0; ++step) {
    const double a = bound / std::sqrt(whole);
    // Johnson, Kotz and Balakrishnan, Continuous univariate distributions 1, 1994, section 13.10.1
    const double inside = std::erf(a / std::numbers::sqrt2);
    const double density = std::exp(-a * a / 2) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
    whole = variance / std::max(0.6, 1 - 2 * a * density / inside);
  }
  return whole;
}

/// The frame at the foot of `place` on a quadric over `frame`, along the normal there.
Frame foot(const Frame& frame, const HeightQuadric& surface, const Vec3& place) {
  const Vec3 at = frame.local(place);
  const Vec3 normal =
      frame.w - surface.slope_x(at.x, at.y) * frame.u - surface.slope_y(at.x, at.y) * frame.v;
  const Vec3 origin = place + (surface.height(at.x, at.y) - at.z) * frame.w;
  return frame_along(origin, (1 / norm(normal)) * normal);
}

}  // namespace

void PatchFitter::find(const Vec3& place, std::size_t count) {
  tree_.nearest_to(place, count, std::numeric_limits<double>::infinity(), found_);
  reach_ = found_.empty() ? 0 : std::sqrt(found_.back().squared_distance);
  // A point that was stored twice, rounded differently, has no noise of its own. Its double is as
  // far away, which puts it next to it.
  constexpr double same = 1e-3;
  std::size_t kept = 0;
  for (const Found& f : found_) {
    const Vec3& p = points_[f.index];
    if (kept > 0 &&
        squared_norm(p - points_[found_[kept - 1].index]) <= same * same * reach_ * reach_) {
      continue;
    }
    found_[kept++] = f;
  }
  found_.resize(kept);
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

QuadricFit PatchFitter::fit_cylinder(double radius, double height) {
  local_.clear();
  for (const Found& f : found_) {
    const Vec3 p = frame_.local(points_[f.index]);
    if (std::abs(p.z) <= height && p.x * p.x + p.y * p.y <= radius * radius) local_.push_back(p);
  }
  return fit_quadric(local_, reach_);
}

/// Half the mean squared difference between the residual of a point and that of the one next to it.
double PatchFitter::half_squared_step() const {
  constexpr std::size_t most = 48;  // enough to tell; all pairs of a large patch take long
  const std::size_t step = std::max<std::size_t>(1, local_.size() / most);
  const auto residual = [&](const Vec3& p) { return p.z - fit_.surface.height(p.x, p.y); };
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < local_.size(); i += step) {
    const Vec3& p = local_[i];
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t next = i;
    for (std::size_t j = 0; j < local_.size(); ++j) {
      const double dx = local_[j].x - p.x;
      const double dy = local_[j].y - p.y;
      const double squared = dx * dx + dy * dy;
      if (squared < nearest && j != i) {
        nearest = squared;
        next = j;
      }
    }
    const double difference = residual(p) - residual(local_[next]);
    sum += 0.5 * difference * difference;
    ++count;
  }
  return sum / count;
}

SurfacePatch PatchFitter::fit(Vec3& place, std::size_t count) {
  find(place, count);
  // Also where squares overflow.
  if (!(reach_ > 0) || !std::isfinite(reach_)) return {};
  frame_ = principal_frame(place);
  fit_ = fit_all(frame_);
  SurfacePatch patch;
  // The ball cuts off points by their noise, the cylinder only by their place on the surface. Its
  // axis comes from a fit, and a second round takes out the tilt of the first.
  for (int round = 0; round < 2; ++round) {
    frame_ = foot(frame_, fit_.surface, place);
    if (!is_finite(frame_.origin) || !is_finite(frame_.w)) return {};
    constexpr double off = 0.15;
    if (norm(frame_.origin - place) > off * reach_) find(frame_.origin, count);
    place = frame_.origin;
    const double height =
        std::clamp(window * std::sqrt(fit_.variance()), lowest * reach_, highest * reach_);
    radius_ = std::sqrt(reach_ * reach_ - height * height);
    fit_ = fit_cylinder(radius_, height);
    if (!(fit_.freedom() > 0)) return {};
    patch = {.variance = whole_variance(fit_.variance(), height),
             .freedom = fit_.freedom(),
             .reach = reach_,
             .spacing = radius_ * std::sqrt(std::numbers::pi / static_cast<double>(fit_.count))};
  }
  patch.whiteness = fit_.variance() > 0 ? half_squared_step() / fit_.variance() : 0;
  return patch;
}

const std::vector<double>& PatchFitter::heights(std::size_t count) {
  find(frame_.origin, count);
  heights_.clear();
  for (const Found& f : found_) {
    const Vec3 p = frame_.local(points_[f.index]);
    if (p.x * p.x + p.y * p.y <= radius_ * radius_) {
      heights_.push_back(p.z - fit_.surface.height(p.x, p.y));
    }
  }
  return heights_;
}

double PatchFitter::height_limit() const {
  return std::sqrt(std::max(0.0, reach_ * reach_ - radius_ * radius_));
}

}  // namespace deburr

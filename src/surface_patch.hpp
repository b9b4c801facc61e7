// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "deburr/vec3.hpp"
#include "kd_tree.hpp"
#include "quadric_fit.hpp"

namespace deburr {

/// The surface about a place, as the points within one distance of it show it.
struct SurfacePatch {
  double variance = 0;  ///< of the heights about a quadric
  double freedom = 0;   ///< degrees of freedom of `variance`; 0 where nothing could be fitted
  double reach = 0;     ///< radius of the ball that the points were taken from
  double spacing = 0;   ///< square root of the area per point
  /// Half the mean squared difference of neighbouring residuals over `variance`: about 1 for noise,
  /// less where the residuals follow a shape that no quadric has.
  double whiteness = 0;
};

/// Fits quadrics to the points about a place.
class PatchFitter {
 public:
  /// Both must outlive this object; `tree` is over `points`.
  PatchFitter(Points points, const KdTree& tree) : points_(points), tree_(tree) {}

  /// The patch of the `count` points nearest to `place`, which is moved onto the surface.
  SurfacePatch fit(Vec3& place, std::size_t count);

  /// The points that the last patch was fitted to, heights over the plane across it.
  [[nodiscard]] std::span<const Vec3> members() const { return local_; }

  /// The heights over the last patch of all points across it that are among the `count` nearest to
  /// its middle, also those far off, which fit() leaves out.
  /// @pre the last patch has a freedom > 0
  const std::vector<double>& heights(std::size_t count);
  /// How far up and down heights() looks at least.
  [[nodiscard]] double height_limit() const;

 private:
  void find(const Vec3& place, std::size_t count);
  [[nodiscard]] Frame principal_frame(const Vec3& place) const;
  QuadricFit fit_all(const Frame& frame);
  QuadricFit fit_cylinder(double radius, double height);
  [[nodiscard]] double half_squared_step() const;

  Points points_;
  const KdTree& tree_;
  double reach_ = 0;
  // Of the last patch:
  Frame frame_;
  QuadricFit fit_;
  double radius_ = 0;
  std::vector<double> heights_;
  std::vector<Found> found_;
  std::vector<Vec3> local_;
};

}  // namespace deburr

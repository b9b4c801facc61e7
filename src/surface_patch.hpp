// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
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
};

/// Fits quadrics to the points about a place.
class PatchFitter {
 public:
  /// Both must outlive this object; `tree` is over `points`.
  PatchFitter(Points points, const KdTree& tree) : points_(points), tree_(tree) {}

  /// The patch of the `count` points nearest to `place`, which is moved onto the surface.
  SurfacePatch fit(Vec3& place, std::size_t count);

 private:
  void find(const Vec3& place, std::size_t count);
  [[nodiscard]] Frame principal_frame(const Vec3& place) const;
  QuadricFit fit_all(const Frame& frame);
  QuadricFit fit_cylinder(const Frame& frame, double radius, double height);

  Points points_;
  const KdTree& tree_;
  double reach_ = 0;
  std::vector<Found> found_;
  std::vector<Vec3> local_;
};

}  // namespace deburr

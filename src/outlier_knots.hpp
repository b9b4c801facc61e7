// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "cell_grid.hpp"
#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "kd_tree.hpp"
#include "outlier_patch.hpp"
#include "some_points.hpp"

namespace deburr {

/// Stands for no point.
inline constexpr std::uint32_t no_point = ~std::uint32_t{0};

/// Points to fit patches to: the cloud itself, or, where the noise is large against its spacing, a
/// thinned copy. Patches are 4.5 standard deviations of the noise in radius, so that they can tell
/// the thickness of the surface from its extent, and hold a number of points that does not depend
/// on the noise.
class Knots {
 public:
  /// @param points  distinct, at least 64; must outlive this
  Knots(const SomePoints& points, const Execution& execution);

  /// The patch of the knots nearest to a place; point `but` is not among them.
  /// @param[out] near  those knots
  [[nodiscard]] Patch patch_at(const Vec3& at, std::uint32_t but, std::vector<Vec3>& near) const;

  /// Points that one knot stands for, at most.
  [[nodiscard]] std::size_t group() const { return group_; }
  [[nodiscard]] std::size_t per_patch() const { return count_; }

 private:
  /// Noise and radius of patches of `count_` knots, as seen at some hundred places.
  struct Trial {
    double noise = 0;
    double radius = 0;
  };
  [[nodiscard]] Trial try_out(const Execution& execution) const;
  void find_near(const Vec3& at, std::size_t count, std::vector<Found>& found) const;
  void thin(std::size_t group, const Execution& execution);

  const SomePoints& some_;
  Points points_;
  std::size_t group_ = 1;
  std::size_t count_ = 0;
  std::vector<Vec3> thinned_;  ///< empty for a group of 1
  std::unique_ptr<KdTree> thinned_tree_;
  std::optional<CellGrid> grid_;  ///< of the knots, where most searches need it only
};

/// Of points[ids[i]], the index of the one nearest to their mean.
[[nodiscard]] std::uint32_t middle_point(Points points, std::span<const std::uint32_t> ids);

/// 80th percentile of distances over that of a normal distribution of deviation 1: up to four
/// fifths may be free of noise, and a tenth anything at all. Reorders them.
[[nodiscard]] double spread(std::span<double> distances);

}  // namespace deburr

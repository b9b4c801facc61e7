// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "kd_tree.hpp"
#include "outlier_knots.hpp"
#include "outlier_patch.hpp"
#include "some_points.hpp"

namespace deburr {

/// The surface that points sample, as patches, with the noise around each.
class RoughSurface {
 public:
  /// As Knots.
  RoughSurface(const SomePoints& points, const Execution& execution);

  /// Distance of one of the points from the patch of its cell, over the noise there: cheap.
  /// Infinite where the patch is too far away to tell.
  [[nodiscard]] double rough_score(std::uint32_t point) const;

  /// Distance of any place from a patch fitted around its foot, over the noise there. Point `self`,
  /// or no_point, does not take part in the fit. Infinite where no surface is near.
  [[nodiscard]] double fine_score(const Vec3& at, std::uint32_t self) const;

  [[nodiscard]] const Knots& knots() const { return knots_; }

 private:
  struct Cell {
    Patch patch;
    double noise = 0;  ///< of the points in the cell, then of those around it too
  };
  void fit_cells(const Execution& execution);
  /// The cell with the nearest centre.
  [[nodiscard]] std::uint32_t nearest_cell(const Vec3& at, double& squared_distance) const;
  void smooth_noise(const Execution& execution);

  const SomePoints& some_;
  Points points_;
  Knots knots_;
  std::vector<std::uint32_t> cell_;  ///< of each point
  std::vector<double> distance_;     ///< of each point from the patch of its cell, or infinity
  std::vector<Cell> cells_;
  std::unique_ptr<KdTree> center_tree_;
  std::vector<Vec3> centers_;
};

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "automatic_parts.hpp"
#include "deburr/execution.hpp"
#include "kd_tree.hpp"
#include "sheet_fit.hpp"

namespace deburr {

/// What nodes that were fitted at all scales tell.
struct ScaleSurvey {
  std::vector<Vec3> places;
  std::vector<Vec3> normals;
  std::vector<ScaleCurve> curves;
  /// Mean number of nodes of level 0 in one of each level.
  std::array<double, node_levels> merged{};
};

/// Chooses the scale of the fits around each place from the curves of all nodes near it.
///
/// The misfit at a scale is what the residuals there exceed those at small scales; it takes
/// thousands of points to tell it from chance. So the misfit of the whole cloud is taken for each
/// node, but for as much as the nodes around it differ significantly. The scale is the one that
/// makes the squared misfit and the variance together least. See docs/method/automatic.md.
class ScaleChooser {
 public:
  /// @param survey  has to live as long
  /// @param noise  standard deviation of the noise of the cloud
  ScaleChooser(const ScaleSurvey& survey, double noise, const AutomaticParts& parts = {},
               const Execution& execution = {});

  // The tree looks at the survey.
  ScaleChooser(const ScaleChooser&) = delete;
  ScaleChooser& operator=(const ScaleChooser&) = delete;
  ~ScaleChooser() = default;

  /// The choices at places that follow each other closely.
  [[nodiscard]] std::vector<ScaleChoice> choose(Points places, Normals normals) const;

 private:
  const ScaleSurvey& survey_;
  double noise_;
  AutomaticParts parts_;
  KdTree tree_;
  std::array<double, sheet_scales> of_cloud_{};
  double free_coarse_excess_;
};

}  // namespace deburr

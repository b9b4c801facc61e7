// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "automatic_parts.hpp"
#include "kd_tree.hpp"
#include "nearest_beside.hpp"
#include "node_levels.hpp"
#include "sheet.hpp"
#include "sheet_samples.hpp"

namespace deburr {

/// Scales at which a sheet is fitted over the nodes of one level, and over those of all.
inline constexpr std::size_t level_scales = 8;
inline constexpr std::size_t sheet_scales = level_scales * node_levels;

/// How the fits around one node fare at each scale; variances are shares of that of the noise.
struct ScaleCurve {
  std::array<float, sheet_scales> residual{};  ///< variance of the points about the fit
  std::array<float, sheet_scales> freedom{};   ///< degrees of freedom of that; 0 where no fit is
  std::array<float, sheet_scales> variance{};  ///< of the height at the node
  /// What the three quadratic terms take off the residuals, in units of what noise alone lets them
  /// take off.
  std::array<float, sheet_scales> curvature{};
};

/// What is known, from all nodes around one, of how it is fitted best.
struct ScaleChoice {
  std::size_t scale = sheet_scales - 1;         ///< no larger than this
  double noise = 0;                             ///< standard deviation of the noise there
  std::array<float, sheet_scales> curvature{};  ///< as in ScaleCurve, pooled; < 0 where unknown
};

/// Fits sheets to nodes, from small neighbourhoods to large ones. See docs/method/automatic.md.
class SheetFitter {
 public:
  /// @param noise  standard deviation of the noise of a single point
  SheetFitter(const NodeLevels& levels, double noise, const AutomaticParts& parts = {})
      : levels_(levels), noise_(noise), parts_(parts) {}

  /// Buffers of one thread.
  struct Scratch {
    std::vector<Found> found;
    SheetSamples samples;
    std::array<NearestBeside, node_levels> nearest;
  };

  /// Tells that nodes in [begin, end) will be fitted; they are sooner found then.
  void expect(std::size_t begin, std::size_t end, Scratch& scratch) const {
    scratch.nearest[0].expect(Points(levels_.nodes(0).places).subspan(begin, end - begin));
  }

  /// Fits node i at every scale and tells how each fares.
  [[nodiscard]] Sheet survey(std::uint32_t i, Scratch& scratch, ScaleCurve& curve) const;

  /// Fits node i at the largest scale that its choice allows and that agrees with the smaller ones.
  [[nodiscard]] Sheet fit(std::uint32_t i, Scratch& scratch, const ScaleChoice& choice) const;

 private:
  struct Run;
  [[nodiscard]] Sheet grow(std::uint32_t i, Scratch& scratch, const ScaleChoice& choice,
                           ScaleCurve* curve) const;

  const NodeLevels& levels_;
  double noise_;
  AutomaticParts parts_;
};

}  // namespace deburr

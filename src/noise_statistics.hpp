// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "deburr/noise.hpp"
#include "surface_patch.hpp"

namespace deburr {

/// What patches of one size show together.
struct SizeEstimate {
  std::size_t count = 0;  ///< points that the patches were asked for
  double sigma = 0;
  double spacing = 0;
  double reach = 0;
  double white = 0;  ///< share of the patches whose residuals look like noise

  /// Reach over what it should at least be; from 1 on the patches are larger than the noise.
  [[nodiscard]] double resolution() const;
};

/// Which share of the patches counts as flat, and the quantile of the normal distribution for it.
struct Flattest {
  double share;
  double quantile;
};
inline constexpr Flattest flattest_of_all{0.1, -1.2816};
inline constexpr Flattest flattest_of_few{0.25, -0.6745};

/// Combines patches that were asked for `count` points.
SizeEstimate combine(std::span<const SurfacePatch> patches, std::size_t count,
                     const Flattest& flattest);

/// The estimate at the size where the resolution passes 1, between two sizes.
SizeEstimate between(const SizeEstimate& too_small, const SizeEstimate& large);

/// Whether larger patches show the same surface as smaller ones that resolve the noise.
bool continues(const SizeEstimate& smaller, const SizeEstimate& larger);

}  // namespace deburr

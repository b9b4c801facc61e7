// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "deburr/noise.hpp"
#include "surface_patch.hpp"

namespace deburr {

/// What patches of one size say of the noise.
NoiseEstimate combine_patches(std::span<const SurfacePatch> patches);

/// Radius of a patch that shows the noise, in standard deviations that it finds.
inline constexpr double sufficient_reach = 3.4;

}  // namespace deburr

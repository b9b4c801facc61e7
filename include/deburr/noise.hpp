// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Estimates the standard deviation of the noise across the surface, in input units, from the
/// points alone: 1.4826 x the median absolute residual of local plane fits, over the half of the
/// points whose fits are flattest, corrected for the degrees of freedom of the fit.
///
/// Points that are not finite do not count. 0 when fewer than 16 points are left. A plane fitted to
/// 24 points cannot see noise much larger than the extent of those points: beyond
/// about one spacing the estimate is too low.
[[nodiscard]] double estimate_noise(Points points, const Execution& execution = {});

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "deburr/execution.hpp"

namespace deburr {

/// Score above which points are outliers.
///
/// @param scores  distances from the surface over the noise; infinite far off
/// @return the smallest score above which no more points of the surface are expected than outliers
///         below it, and at most 4 % of all there, in [2, 4] times a factor; 4 times it where there
///         is none. The factor, in [0.8, 2], is how much larger the noise is, or how much longer
///         its tail, than scores say.
[[nodiscard]] double score_threshold(std::span<const double> scores, const Execution& execution);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace deburr {

/// Score above which points are outliers.
///
/// @param scores  distances from the surface over the noise; infinite far off
/// @return the smallest score from 2.5 to 4 above which at most 3.5 % are expected to be of the
///         surface, times a factor of 1 to 2 where the noise is larger or has longer tails than
///         scores say; 4 times that factor where none is
[[nodiscard]] double score_threshold(std::vector<double> scores);

}  // namespace deburr

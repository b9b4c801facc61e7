// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/metrics.hpp"

namespace deburr {

/// Summarises the distances that are not NaN. Sums run in their order.
[[nodiscard]] DistanceError summarize(std::vector<double> distances, double diagonal);

}  // namespace deburr

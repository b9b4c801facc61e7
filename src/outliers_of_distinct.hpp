// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/outliers.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// find_outliers() of points that are finite, all different, in spatial order and of a size near 1,
/// as those of a WorkingSet are.
[[nodiscard]] std::vector<std::uint8_t> find_outliers_of_distinct(Points points,
                                                                  const OutlierOptions& options,
                                                                  const Execution& execution);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "deburr/point_cloud.hpp"

namespace deburr::view {

/// For a result of denoise that lacks the outliers of its input: of every point of `after` its
/// index in `before`. The order is the same in both, and each point lies as far from where it was
/// as its deburr_displacement says. Empty where this cannot be: `after` has no such field or is not
/// smaller, or its points do not fit.
[[nodiscard]] std::vector<std::uint32_t> match_without_removed(const PointCloud& before,
                                                               const PointCloud& after);

}  // namespace deburr::view

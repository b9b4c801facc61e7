// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "deburr/features.hpp"

namespace deburr {

/// The same class everywhere.
inline FeatureField all(Feature label, std::size_t n, const Vec3& direction = {}) {
  return {std::vector<Feature>(n, label), std::vector<Vec3>(n, direction)};
}

}  // namespace deburr

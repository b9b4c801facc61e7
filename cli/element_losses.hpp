// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "deburr/point_cloud.hpp"

namespace deburr::cli {

/// Name and number of items of an element, such as the faces of a mesh.
using ElementSize = std::pair<std::string, std::size_t>;

[[nodiscard]] std::vector<ElementSize> element_sizes(const PointCloud& cloud);

/// Adds a warning for every element that lost items when points were removed.
void warn_of_lost_elements(const std::string& input, const std::vector<ElementSize>& before,
                           const std::vector<ElementSize>& after,
                           std::vector<std::string>& warnings);

}  // namespace deburr::cli

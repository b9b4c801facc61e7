// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// For every point the one that stands for it: itself, or an earlier one that is nearer than a
/// thousandth of the spacing there, as where a cloud was merged with a rounded copy of itself.
/// Empty where no point has another one for it: always where fewer than one in a thousand points
/// would, since such pairs are there by chance.
/// @param points  distinct, in spatial order, around the origin and at most about 2 from it
[[nodiscard]] std::vector<std::uint32_t> find_near_duplicates(Points points,
                                                              const Execution& execution);

}  // namespace deburr

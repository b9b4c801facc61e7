// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace deburr {

/// Numbers of values that sort_in_lanes() sorts.
inline constexpr std::array<std::size_t, 4> lane_sort_sizes{32, 64, 128, 256};

/// Sorts 32, 64, 128 or 256 values, none of them NaN, without a branch: the order that they come in
/// costs no time.
void sort_in_lanes(double* values, std::size_t size);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

namespace deburr {

/// Numbers of values that sort_in_lanes() sorts.
inline constexpr std::array<std::size_t, 4> lane_sort_sizes{32, 64, 128, 256};

/// Sorts 32, 64, 128 or 256 values, none of them NaN, without a branch: the order of the values
/// costs no time. Afterwards the k-th smallest stands at lane_sorted(k, size).
void sort_in_lanes(double* values, std::size_t size);

/// Each of the eight lanes holds an eighth of the sorted values.
inline std::size_t lane_sorted(std::size_t k, std::size_t size) {
  const std::size_t rows = size / 8;  // a power of two
  return (k % rows) * 8 + (k >> static_cast<unsigned>(std::countr_zero(rows)));
}

}  // namespace deburr

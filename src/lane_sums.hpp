// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

#include "lanes.hpp"

namespace deburr {

/// What the sums over the lanes of several values go through, half as wide.
using HalfLanes = double __attribute__((vector_size(lane_count / 2 * sizeof(double))));

DEBURR_LANES_INLINE HalfLanes halves_added(const Lanes& v) {
  std::array<HalfLanes, 2> half;
  std::memcpy(half.data(), &v, sizeof v);
  return half[0] + half[1];
}
DEBURR_LANES_INLINE HalfLanes halves_added(const HalfLanes& v) { return v; }

/// sum() of each value, with the same bits: four at a time, since adding up the lanes of one takes
/// as long as a dozen additions of lanes. Each value comes as it is or with its halves added.
template <typename Value, std::size_t count>
DEBURR_LANES_INLINE void sum_each(const std::array<Value, count>& values, double* sums) {
  static_assert(count % 4 == 0);
  for (std::size_t k = 0; k < count; k += 4) {
    const HalfLanes a = halves_added(values[k]);
    const HalfLanes b = halves_added(values[k + 1]);
    const HalfLanes c = halves_added(values[k + 2]);
    const HalfLanes d = halves_added(values[k + 3]);
    const HalfLanes ac =
        __builtin_shufflevector(a, c, 0, 1, 4, 5) + __builtin_shufflevector(a, c, 2, 3, 6, 7);
    const HalfLanes bd =
        __builtin_shufflevector(b, d, 0, 1, 4, 5) + __builtin_shufflevector(b, d, 2, 3, 6, 7);
    const HalfLanes all =
        __builtin_shufflevector(ac, bd, 0, 4, 2, 6) + __builtin_shufflevector(ac, bd, 1, 5, 3, 7);
    std::memcpy(sums + k, &all, sizeof all);
  }
}

}  // namespace deburr

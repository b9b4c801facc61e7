// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "columns.hpp"
#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "lanes.hpp"
#include "parallel.hpp"

namespace deburr {

/// A vector that is read in one go and never lies across two cache lines.
struct alignas(4 * sizeof(double)) Row {
  double x = 0, y = 0, z = 0, unused = 0;

  Row() = default;
  explicit Row(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}
  explicit operator Vec3() const { return {x, y, z}; }
};

inline std::vector<Row> make_rows(std::span<const Vec3> values, const Execution& execution) {
  auto rows = make_column<Row>(values.size(), execution);
  parallel_for(values.size(), without_progress(execution),
               [&](std::size_t i) { rows[i] = Row(values[i]); });
  return rows;
}

/// Eight rows turned into columns.
DEBURR_LANES_INLINE Lanes3 columns(const Row& r0, const Row& r1, const Row& r2, const Row& r3,
                                   const Row& r4, const Row& r5, const Row& r6, const Row& r7) {
  // Four doubles at a time: what every vector unit since AVX can do. Wider shuffles would be taken
  // apart, entry by entry, where there is no AVX-512.
  using Four = double __attribute__((vector_size(4 * sizeof(double))));
  const auto four = [](const Row& r) __attribute__((always_inline)) {
    Four v;
    std::memcpy(&v, &r, sizeof v);
    return v;
  };
  const Four v0 = four(r0), v1 = four(r1), v2 = four(r2), v3 = four(r3);
  const Four v4 = four(r4), v5 = four(r5), v6 = four(r6), v7 = four(r7);
  const Four xz01 = __builtin_shufflevector(v0, v1, 0, 4, 2, 6);
  const Four xz23 = __builtin_shufflevector(v2, v3, 0, 4, 2, 6);
  const Four xz45 = __builtin_shufflevector(v4, v5, 0, 4, 2, 6);
  const Four xz67 = __builtin_shufflevector(v6, v7, 0, 4, 2, 6);
  const Four yu01 = __builtin_shufflevector(v0, v1, 1, 5, 3, 7);
  const Four yu23 = __builtin_shufflevector(v2, v3, 1, 5, 3, 7);
  const Four yu45 = __builtin_shufflevector(v4, v5, 1, 5, 3, 7);
  const Four yu67 = __builtin_shufflevector(v6, v7, 1, 5, 3, 7);
  const Four xa = __builtin_shufflevector(xz01, xz23, 0, 1, 4, 5);
  const Four xb = __builtin_shufflevector(xz45, xz67, 0, 1, 4, 5);
  const Four ya = __builtin_shufflevector(yu01, yu23, 0, 1, 4, 5);
  const Four yb = __builtin_shufflevector(yu45, yu67, 0, 1, 4, 5);
  const Four za = __builtin_shufflevector(xz01, xz23, 2, 3, 6, 7);
  const Four zb = __builtin_shufflevector(xz45, xz67, 2, 3, 6, 7);
  return {__builtin_shufflevector(xa, xb, 0, 1, 2, 3, 4, 5, 6, 7),
          __builtin_shufflevector(ya, yb, 0, 1, 2, 3, 4, 5, 6, 7),
          __builtin_shufflevector(za, zb, 0, 1, 2, 3, 4, 5, 6, 7)};
}

/// Eight neighbours at a time; at the end of the list the missing ones are the zero vector.
DEBURR_LANES_INLINE Lanes3 load(const Row* rows, std::span<const std::uint32_t> list,
                                std::size_t from) {
  const std::uint32_t* const at = list.data() + from;
  if (from + lane_count <= list.size()) {
    return columns(rows[at[0]], rows[at[1]], rows[at[2]], rows[at[3]], rows[at[4]], rows[at[5]],
                   rows[at[6]], rows[at[7]]);
  }
  const std::size_t left = list.size() - from;
  const Row none;
  const auto row = [&](std::size_t l) -> const Row& { return l < left ? rows[at[l]] : none; };
  return columns(row(0), row(1), row(2), row(3), row(4), row(5), row(6), none);
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace deburr {

/// Cells along each axis that the curve has room for.
inline constexpr std::uint64_t z_order_cells = std::uint64_t{1} << 21;

/// Spreads the low 21 bits of v so that two zeros follow each.
inline std::uint64_t spread_bits(std::uint64_t v) {
  v = (v | v << 32) & 0x001f00000000ffffU;
  v = (v | v << 16) & 0x001f0000ff0000ffU;
  v = (v | v << 8) & 0x100f00f00f00f00fU;
  v = (v | v << 4) & 0x10c30c30c30c30c3U;
  return (v | v << 2) & 0x1249249249249249U;
}

/// Where a cell comes along the Z-order curve. Near on it means near in space.
/// @param x,y,z  of the cell, < z_order_cells
inline std::uint64_t z_order(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
  return spread_bits(x) | spread_bits(y) << 1 | spread_bits(z) << 2;
}

}  // namespace deburr

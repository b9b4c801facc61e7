// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace deburr {

/// Appends the begins of the ranges that halving [begin, end) gives until none is larger than
/// `most`, >= 1.
inline void add_halves(std::size_t begin, std::size_t end, std::size_t most,
                       std::vector<std::uint32_t>& begins) {
  if (end - begin <= most) {
    begins.push_back(static_cast<std::uint32_t>(begin));
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  add_halves(begin, middle, most, begins);
  add_halves(middle, end, most, begins);
}

/// Those of [0, n), and n.
inline std::vector<std::uint32_t> halves(std::size_t n, std::size_t most) {
  std::vector<std::uint32_t> begins;
  add_halves(0, n, most, begins);
  begins.push_back(static_cast<std::uint32_t>(n));
  return begins;
}

}  // namespace deburr

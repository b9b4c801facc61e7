// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace deburr {

/// Begins of the ranges that halving [0, n) gives until none is larger than `most`, >= 1. Ends with
/// n.
inline std::vector<std::uint32_t> halves(std::size_t n, std::size_t most) {
  std::vector<std::uint32_t> begins;
  const auto split = [&](const auto& self, std::size_t begin, std::size_t end) -> void {
    if (end - begin <= most) {
      begins.push_back(static_cast<std::uint32_t>(begin));
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    self(self, begin, middle);
    self(self, middle, end);
  };
  split(split, 0, n);
  begins.push_back(static_cast<std::uint32_t>(n));
  return begins;
}

}  // namespace deburr

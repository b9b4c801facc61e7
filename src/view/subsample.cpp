// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/subsample.hpp"

#include <algorithm>

#include "spatial_order.hpp"

namespace deburr::view {
namespace {

std::uint32_t reversed(std::uint32_t value, unsigned digits) {
  std::uint32_t result = 0;
  for (unsigned i = 0; i < digits; ++i) result |= ((value >> i) & 1U) << (digits - 1 - i);
  return result;
}

}  // namespace

std::vector<std::uint32_t> progressive_order(std::uint32_t count) {
  unsigned digits = 0;
  while (digits < 32 && (std::uint64_t{1} << digits) < count) ++digits;
  std::vector<std::uint32_t> order;
  order.reserve(count);
  for (std::uint64_t i = 0; i < (std::uint64_t{1} << digits); ++i) {
    const std::uint32_t place = reversed(static_cast<std::uint32_t>(i), digits);
    if (place < count) order.push_back(place);
  }
  return order;
}

std::vector<std::uint32_t> even_subsample(Points points, std::span<const std::uint32_t> candidates,
                                          std::size_t count, const Execution& execution) {
  const std::vector<std::uint32_t> curve =
      spatial_order(gather<Vec3>(points, candidates), execution);
  const std::size_t chosen = std::min(count, curve.size());
  std::vector<std::uint32_t> result;
  result.reserve(chosen);
  for (const std::uint32_t step : progressive_order(static_cast<std::uint32_t>(chosen))) {
    const std::size_t along = step * curve.size() / chosen;
    result.push_back(candidates[curve[along]]);
  }
  return result;
}

}  // namespace deburr::view

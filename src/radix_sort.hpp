// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "columns.hpp"
#include "parallel.hpp"

namespace deburr {

inline constexpr unsigned radix_bits = 11;

/// Sorts items by the lowest `digits` times `radix_bits` bits of key(item), and leaves those of one
/// key in their order, in time in proportion to their number.
/// @param scratch  grows to as many items; to be used again
template <unsigned digits, typename Item, typename Key>
void radix_sort(std::span<Item> items, std::vector<Item>& scratch, const Key& key,
                const Execution& execution) {
  constexpr std::size_t values = std::size_t{1} << radix_bits;
  constexpr std::size_t chunk = 32 * block_size;
  using Counts = std::array<std::uint32_t, values>;
  const Execution quiet = without_progress(execution);
  if (scratch.size() < items.size()) resize_column(scratch, items.size(), quiet);
  std::vector<Counts> places((items.size() + chunk - 1) / chunk);
  std::span<Item> from = items;
  std::span<Item> to = std::span(scratch).first(items.size());
  for (unsigned d = 0; d < digits; ++d) {
    const auto digit = [&](const Item& item) { return (key(item) >> (d * radix_bits)) % values; };
    const auto for_each_chunk = [&](const auto& visit) {
      parallel_for<1>(places.size(), quiet, [&](std::size_t c) {
        visit(from.subspan(c * chunk, std::min(chunk, from.size() - c * chunk)), places[c]);
      });
    };
    for_each_chunk([&](std::span<const Item> of_chunk, Counts& count) {
      count.fill(0);
      for (const Item& item : of_chunk) ++count[digit(item)];
    });
    std::uint32_t sum = 0;
    for (std::size_t v = 0; v < values; ++v) {
      for (Counts& place : places) sum += std::exchange(place[v], sum);
    }
    for_each_chunk([&](std::span<const Item> of_chunk, Counts& place) {
      for (const Item& item : of_chunk) to[place[digit(item)]++] = item;
    });
    std::swap(from, to);
  }
  if (digits % 2 == 0) return;
  parallel_blocks(items.size(), quiet, [&](std::size_t begin, std::size_t end) {
    std::ranges::copy(from.subspan(begin, end - begin), to.subspan(begin).begin());
  });
}

}  // namespace deburr

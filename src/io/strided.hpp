// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "deburr/vec3.hpp"
#include "io/bytes.hpp"

// Columns of numbers from and to rows of a binary file. All that a loop needs stands in arguments:
// bytes that are stored could be part of any object, which would be loaded again for each number.

namespace deburr {

/// Stores numbers at places that are a stride apart, least byte first.
template <typename T>
void scatter(const T* from, std::size_t n, char* to, std::size_t stride) {
  if (is_little_endian && stride == sizeof(T) && n > 0) {
    std::memcpy(to, from, n * sizeof(T));
    return;
  }
  for (; n > 0; --n, to += stride) store_little(to, *from++);
}

/// Loads numbers from places that are a stride apart, least byte first.
template <typename T>
void gather(const char* from, std::size_t n, std::size_t stride, T* to) {
  if (is_little_endian && stride == sizeof(T) && n > 0) {
    std::memcpy(to, from, n * sizeof(T));
    return;
  }
  for (; n > 0; --n, from += stride) *to++ = load_little<T>(from);
}

/// Stores one axis of vectors as numbers of type T.
template <typename T>
void scatter_axis(const Vec3* from, double Vec3::*axis, std::size_t n, char* to,
                  std::size_t stride) {
  for (; n > 0; --n, to += stride) store_little(to, static_cast<T>((from++)->*axis));
}

/// Bits that a byte of a row has for a field.
struct ByteBits {
  unsigned shift = 0;
  unsigned mask = 0xff;  ///< of the value, once it is shifted down
};

/// The values of a field of bits, eight bytes at a time.
inline void take_bits(const std::uint8_t* from, std::size_t n, ByteBits bits, std::uint8_t* to) {
  constexpr std::uint64_t each = 0x0101010101010101U;
  const std::uint64_t mask = each * bits.mask;
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, from + i, 8);
    word = (word >> bits.shift) & mask;
    std::memcpy(to + i, &word, 8);
  }
  for (; i < n; ++i)
    to[i] = static_cast<std::uint8_t>((unsigned{from[i]} >> bits.shift) & bits.mask);
}

/// Adds the values of a field of bits, which fit into it, to bytes that have zeros there.
inline void add_bits(const std::uint8_t* from, std::size_t n, unsigned shift, std::uint8_t* to) {
  std::size_t i = 0;
  for (; i + 8 <= n; i += 8) {
    std::uint64_t word = 0;
    std::uint64_t sum = 0;
    std::memcpy(&word, from + i, 8);
    std::memcpy(&sum, to + i, 8);
    sum |= word << shift;
    std::memcpy(to + i, &sum, 8);
  }
  for (; i < n; ++i) to[i] = static_cast<std::uint8_t>(to[i] | unsigned{from[i]} << shift);
}

/// The least and the most of integers of which there is at least one, several at a time.
template <typename T>
std::array<T, 2> ends_of(std::span<const T> values) {
  constexpr std::size_t bytes = 32;
  constexpr std::size_t lanes = bytes / sizeof(T);
  using Lanes [[gnu::vector_size(bytes)]] = T;
  Lanes least = Lanes{} + values.front();
  Lanes most = least;
  std::size_t i = 0;
  for (; i + lanes <= values.size(); i += lanes) {
    Lanes v;
    std::memcpy(&v, values.data() + i, bytes);
    least = v < least ? v : least;
    most = v > most ? v : most;
  }
  std::array<T, 2> ends{values.front(), values.front()};
  const auto take = [&](T low, T high) {
    ends = {std::min(ends[0], low), std::max(ends[1], high)};
  };
  for (std::size_t l = 0; l < lanes; ++l) take(least[l], most[l]);
  for (; i < values.size(); ++i) take(values[i], values[i]);
  return ends;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "deburr/vec3.hpp"

// Numbers of a page: small integers, little-endian, and text for the bytes.

namespace deburr::view {

/// How a real number is kept as an integer q: low + step * q, q in [0, levels]. A range without
/// extent has step 0.
struct Quantiser {
  double low = 0;
  double step = 0;
  std::uint32_t levels = 0;

  /// @param low, high  finite, low <= high
  static Quantiser over(double low, double high, std::uint32_t levels);
  /// From -most to most, and 0 is kept exactly.
  static Quantiser about_zero(double most, std::uint32_t levels);

  /// The nearest integer; values outside go to the ends, NaN to 0.
  [[nodiscard]] std::uint32_t operator()(double value) const;
  [[nodiscard]] double value(std::uint32_t q) const { return low + step * q; }
};

inline constexpr std::uint32_t levels_16 = (1U << 16) - 1;
inline constexpr std::uint32_t levels_24 = (1U << 24) - 1;

/// Appends the lowest `bytes` bytes of a number, the lowest first.
void append_number(std::string& bytes_out, std::uint32_t value, int bytes);

/// A direction in two bytes, by the octahedral map (Meyer et al., On Floating-Point Normal Vectors,
/// 2010): at most 1.1 degrees off. A vector without length is taken for (0, 0, 1).
[[nodiscard]] std::array<std::uint8_t, 2> pack_direction(const Vec3& direction);

/// The unit vector of two bytes.
[[nodiscard]] Vec3 unpack_direction(std::array<std::uint8_t, 2> packed);

/// RFC 4648, with padding.
[[nodiscard]] std::string base64(std::string_view bytes);

/// Length of base64 text for so many bytes.
[[nodiscard]] constexpr std::size_t base64_size(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

}  // namespace deburr::view

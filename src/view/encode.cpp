// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/encode.hpp"

#include <algorithm>
#include <cmath>

namespace deburr::view {
namespace {

constexpr double byte_scale = 127;  // bytes 0 to 254, so that 0 is met exactly

std::uint8_t to_byte(double value) {
  return static_cast<std::uint8_t>(std::lround((std::clamp(value, -1.0, 1.0) + 1) * byte_scale));
}

double sign(double value) { return value < 0 ? -1 : 1; }

}  // namespace

Quantiser Quantiser::over(double low, double high, std::uint32_t levels) {
  // The extent may be more than a double holds.
  return {low, high > low ? high / levels - low / levels : 0, levels};
}

Quantiser Quantiser::about_zero(double most, std::uint32_t levels) {
  const std::uint32_t half = levels / 2;
  return {-most, most > 0 ? most / half : 0, 2 * half};
}

std::uint32_t Quantiser::operator()(double value) const {
  const double q = step > 0 ? std::round((value - low) / step) : 0;
  if (!(q > 0)) return 0;
  return q < levels ? static_cast<std::uint32_t>(q) : levels;
}

void append_number(std::string& bytes_out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) bytes_out += static_cast<char>((value >> (8 * i)) & 0xFFU);
}

std::array<std::uint8_t, 2> pack_direction(const Vec3& direction) {
  const double sum = std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z);
  if (!(sum > 0) || !std::isfinite(sum)) return pack_direction({0, 0, 1});
  const double x = direction.x / sum;
  const double y = direction.y / sum;
  if (direction.z >= 0) return {to_byte(x), to_byte(y)};
  return {to_byte((1 - std::abs(y)) * sign(x)), to_byte((1 - std::abs(x)) * sign(y))};
}

Vec3 unpack_direction(std::array<std::uint8_t, 2> packed) {
  double x = packed[0] / byte_scale - 1;
  double y = packed[1] / byte_scale - 1;
  const double z = 1 - std::abs(x) - std::abs(y);
  if (z < 0) {
    const double folded = (1 - std::abs(y)) * sign(x);
    y = (1 - std::abs(x)) * sign(y);
    x = folded;
  }
  return (1 / norm({x, y, z})) * Vec3{x, y, z};
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(base64_size(bytes.size()));
  const auto at = [&](std::size_t i) -> std::uint32_t {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0U;
  };
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t group = (at(i) << 16U) | (at(i + 1) << 8U) | at(i + 2);
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text += digits[(group >> shift) & 63U];
  }
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  text.replace(text.size() - padding, padding, padding, '=');
  return text;
}

}  // namespace deburr::view

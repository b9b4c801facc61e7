// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/packed_arrays.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "view/encode.hpp"

namespace deburr::view {

using Json = nlohmann::ordered_json;

namespace {

Quantiser range_of(std::span<const double> values, double low, double high) {
  const bool whole = high - low <= levels_16 && std::ranges::all_of(values, [](double value) {
                       return !std::isfinite(value) || value == std::round(value);
                     });
  if (whole) return {low, 1, levels_16};
  return low < 0 ? Quantiser::about_zero(std::max(-low, high), levels_16)
                 : Quantiser::over(low, high, levels_16);
}

}  // namespace

Json PackedArrays::add_positions(Points points, const Box& box) {
  const std::array axes{Quantiser::over(box.low.x, box.high.x, levels_24),
                        Quantiser::over(box.low.y, box.high.y, levels_24),
                        Quantiser::over(box.low.z, box.high.z, levels_24)};
  const std::size_t offset = bytes_.size();
  for (const Vec3& p : points) {
    append_number(bytes_, axes[0](p.x), 3);
    append_number(bytes_, axes[1](p.y), 3);
    append_number(bytes_, axes[2](p.z), 3);
  }
  return {{"type", "u24"},
          {"offset", offset},
          {"components", 3},
          {"low", {axes[0].low, axes[1].low, axes[2].low}},
          {"step", {axes[0].step, axes[1].step, axes[2].step}}};
}

Json PackedArrays::add_directions(Normals normals) {
  const std::size_t offset = bytes_.size();
  for (const Vec3& n : normals) {
    for (const std::uint8_t byte : pack_direction(n)) append_number(bytes_, byte, 1);
  }
  return {{"type", "octahedral"}, {"offset", offset}, {"components", 2}};
}

Json PackedArrays::add_numbers(std::span<const double> values) {
  double low = 0;
  double high = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const Quantiser quantise = range_of(values, low, high);
  const std::size_t offset = bytes_.size();
  for (const double value : values) append_number(bytes_, quantise(value), 2);
  return {{"type", "u16"},
          {"offset", offset},
          {"components", 1},
          {"low", {quantise.low}},
          {"step", {quantise.step}}};
}

Json PackedArrays::add_bytes(std::span<const std::uint8_t> values, int components) {
  const std::size_t offset = bytes_.size();
  for (const std::uint8_t value : values) append_number(bytes_, value, 1);
  return {{"type", "u8"}, {"offset", offset}, {"components", components}};
}

}  // namespace deburr::view

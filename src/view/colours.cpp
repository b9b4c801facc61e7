// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "view/colours.hpp"

#include <algorithm>
#include <cmath>

namespace deburr::view {

Rgb sample(std::span<const Rgb> map, double share) {
  if (std::isnan(share)) return unknown_colour;
  const double along = std::clamp(share, 0.0, 1.0) * static_cast<double>(map.size() - 1);
  const std::size_t at = std::min(static_cast<std::size_t>(along), map.size() - 2);
  const double rest = along - static_cast<double>(at);
  Rgb colour{};
  for (std::size_t k = 0; k < colour.size(); ++k) {
    const double value = map[at][k] + rest * (map[at + 1][k] - map[at][k]);
    colour[k] = static_cast<std::uint8_t>(std::lround(value));
  }
  return colour;
}

}  // namespace deburr::view

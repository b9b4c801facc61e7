// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "view/scene.hpp"

namespace deburr::view {

/// Which points of two clouds are the same, and how far they moved.
struct Pairing {
  bool paired = false;
  /// Of every point of `after`, its index in `before`; only where paired.
  std::vector<std::uint32_t> origin;
  /// Of every point of `after`, input units; along its normal where `is_signed`, positive where
  /// the normal points. Empty where nothing is known.
  std::vector<double> displacement;
  bool is_signed = false;
  std::vector<std::string> warnings;
};

/// Without pairs, the displacement is that of the attribute deburr_displacement of the last cloud.
/// @throws std::invalid_argument  as make_scene
[[nodiscard]] Pairing pair_points(const Request& request);

}  // namespace deburr::view

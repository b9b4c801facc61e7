// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "automatic.hpp"

namespace deburr {

/// A first idea of the surface: where each point lies on it, and its normal there.
struct Pilot {
  std::vector<Vec3> places;
  std::vector<Vec3> normals;       ///< unit, or zero where nothing is near
  std::vector<std::uint8_t> lone;  ///< whether nothing is near to be compared with
  bool merged = false;  ///< whether points were merged, and normals that were given dropped
};

/// Runs a few rounds of the published stages at the scale of the noise, over merged points where
/// the cloud is dense against it.
Pilot find_pilot(const AutomaticInput& input, const Execution& execution);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "deburr/denoise.hpp"
#include "deburr/features.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/normal_filter.hpp"
#include "deburr/position_update.hpp"

namespace deburr {

/// A method as the stages and parameters of its rounds, all lengths absolute.
struct Schedule {
  int rounds = 0;
  NeighborOptions neighbors;
  NormalFilterOptions normal_filter;
  FeatureOptions features;
  PositionUpdateOptions update;
  bool rebuild = false;   ///< find the neighbourhoods again in every round
  bool in_place = false;  ///< classify and move point by point
  Voteless voteless_at_first = Voteless::Keep;
};

/// @throws std::invalid_argument  naming the option that is out of its range
void validate(const DenoiseOptions& options);

Schedule make_schedule(const Yadav2018Options& options, double spacing);

}  // namespace deburr

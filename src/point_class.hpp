// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "deburr/features.hpp"
#include "neighbor_sums.hpp"

namespace deburr {

/// The class of one point, with the direction along the edge.
struct PointClass {
  Feature label = Feature::Isolated;
  Vec3 direction;
};
using PointClasses = std::array<PointClass, lane_count>;

/// @throws std::invalid_argument  naming the option that is out of its range
void validate(const FeatureOptions& options);

/// Classifies eight points by their moments; see classify_features.
void classify_points(const Moments& moments, const FeatureOptions& options, PointClasses& classes);

}  // namespace deburr

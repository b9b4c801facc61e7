// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "deburr/features.hpp"

namespace deburr {

/// The class of one point, with the direction along the edge.
struct PointClass {
  Feature label = Feature::Isolated;
  Vec3 direction;
};

/// @throws std::invalid_argument  naming the option that is out of its range
void validate(const FeatureOptions& options);

/// Classifies point i; see classify_features.
PointClass classify_point(std::size_t i, Points points, Normals normals,
                          std::span<const std::uint32_t> neighbors, const FeatureOptions& options);

}  // namespace deburr

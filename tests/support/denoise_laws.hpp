// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "deburr/denoise.hpp"
#include "support/same_cloud.hpp"
#include "support/shapes.hpp"

// What the tests of the laws of the default method share.

namespace deburr {

inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline DenoiseResult run(std::vector<Vec3> points, std::vector<Vec3> normals = {},
                         const Execution& execution = {}) {
  PointCloud cloud;
  cloud.points = std::move(points);
  cloud.normals = std::move(normals);
  return denoise(cloud, {}, execution);
}

/// The noise is a third of the spacing.
inline std::vector<Vec3> noisy_cube() { return with_noise(cube(1500, 1).points, 0.04, 2); }

template <typename Value>
std::vector<Value> picked(const std::vector<Value>& values, std::span<const std::uint32_t> order) {
  std::vector<Value> result;
  for (const std::uint32_t i : order) result.push_back(values[i]);
  return result;
}

inline void expect_same_result(const DenoiseResult& a, const DenoiseResult& b) {
  EXPECT_TRUE(same_values(a.cloud.points, b.cloud.points));
  EXPECT_TRUE(same_values(a.cloud.normals, b.cloud.normals));
  EXPECT_TRUE(same_values(a.displacement, b.displacement));
  EXPECT_EQ(a.labels, b.labels);
  EXPECT_EQ(a.outliers, b.outliers);
}

}  // namespace deburr

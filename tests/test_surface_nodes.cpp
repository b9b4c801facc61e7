// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "support/compare.hpp"
#include "support/shapes.hpp"
#include "surface_nodes.hpp"

namespace deburr {
namespace {

/// Points of a sphere, their noisy positions, and weights from 1 to 3.
struct Patch {
  Sampled surface = sphere(2000, 1);
  std::vector<Vec3> measured = with_noise(surface.points, 0.05, 2);
  std::vector<double> weights;

  Patch() {
    for (int i = 0; i < 2000; ++i) weights.push_back(1 + i % 3);
  }
  [[nodiscard]] SurfaceNodes merged(double cell, const Execution& execution = {}) const {
    return merge_into_cells(measured, surface.points, surface.normals, weights, {}, cell, 1,
                            execution);
  }
};

/// The weighted mean of the values of each node's points.
std::vector<Vec3> means(const SurfaceNodes& nodes, Points values,
                        const std::vector<double>& weights) {
  std::vector<Vec3> sums(nodes.size());
  std::vector<double> totals(nodes.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    sums[nodes.of[i]] += weights[i] * values[i];
    totals[nodes.of[i]] += weights[i];
  }
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = (1 / totals[k]) * sums[k];
  return sums;
}

TEST(SurfaceNodes, AreThePointsThemselvesWhereNothingIsMerged) {
  const Patch patch;
  const SurfaceNodes nodes =
      nodes_of_points(patch.measured, patch.surface.points, patch.surface.normals);
  EXPECT_EQ(nodes.measured, patch.measured);
  EXPECT_EQ(nodes.places, patch.surface.points);
  EXPECT_EQ(nodes.normals, patch.surface.normals);
  EXPECT_EQ(nodes.weight(1999), 1);
  EXPECT_TRUE(nodes.of.empty());
}

TEST(SurfaceNodes, KeepMassAndMeans) {
  const Patch patch;
  const SurfaceNodes nodes = patch.merged(0.3);
  ASSERT_EQ(nodes.measured.size(), nodes.size());
  ASSERT_EQ(nodes.normals.size(), nodes.size());
  ASSERT_EQ(nodes.of.size(), 2000U);
  EXPECT_LT(nodes.size(), 600U);
  EXPECT_GT(nodes.size(), 100U);
  std::vector<double> mass(nodes.size());
  for (std::size_t i = 0; i < 2000; ++i) mass[nodes.of[i]] += patch.weights[i];
  EXPECT_EQ(nodes.weights, mass);
  EXPECT_LE(max_difference(nodes.measured, means(nodes, patch.measured, patch.weights)), 1e-14);
  EXPECT_LE(max_difference(nodes.places, means(nodes, patch.surface.points, patch.weights)), 1e-14);
  const std::vector<Vec3> normals = means(nodes, patch.surface.normals, patch.weights);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    ASSERT_NEAR(norm(nodes.normals[k]), 1, 1e-14);
    ASSERT_LE(norm(cross(nodes.normals[k], normals[k])), 1e-14);
  }
}

TEST(SurfaceNodes, HoldPointsOfOneCellAndOneSideOnly) {
  const Patch patch;
  const SurfaceNodes nodes = patch.merged(0.3);
  std::vector<std::size_t> first(nodes.size(), 2000);
  for (std::size_t i = 0; i < 2000; ++i) {
    std::size_t& other = first[nodes.of[i]];
    if (other == 2000) other = i;
    const Vec3 apart = patch.surface.points[i] - patch.surface.points[other];
    ASSERT_LE(std::max({std::abs(apart.x), std::abs(apart.y), std::abs(apart.z)}), 0.3);
    ASSERT_GT(dot(patch.surface.normals[i], patch.surface.normals[other]), 0);
  }
}

TEST(SurfaceNodes, DoNotJoinTheSidesOfAThinPart) {
  // Ten points on each side, all in one cell.
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  for (int i = 0; i < 10; ++i) {
    for (const double side : {1.0, -1.0}) {
      points.push_back({0.1 * i, 0, 0.01 * side});
      normals.push_back({0, 0, side});
    }
  }
  // Even the point at the far end of the box is in the cell.
  const SurfaceNodes apart = merge_into_cells(points, points, normals, {}, {}, 2, 1, {});
  ASSERT_EQ(apart.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(apart.weights[k], 10);
    EXPECT_NEAR(apart.places[k].z, 0.01 * apart.normals[k].z, 1e-15);
    EXPECT_EQ(std::abs(apart.normals[k].z), 1);
  }
  // Without normals there are no sides.
  const SurfaceNodes together = merge_into_cells(points, points, {}, {}, {}, 2, 1, {});
  ASSERT_EQ(together.size(), 1U);
  EXPECT_EQ(together.weights[0], 20);
  EXPECT_EQ(together.normals[0], Vec3{});
}

TEST(SurfaceNodes, AreTheSameInAnyUnitAndPlace) {
  const Patch patch;
  const SurfaceNodes plain = patch.merged(0.21);
  for (const double unit : {0x1p-30, 1e-6, 1e6}) {
    for (const double far : {0.0, 1000.0}) {
      const auto map = [&](const Vec3& p) { return unit * (p + Vec3{far, -far, 2 * far}); };
      const SurfaceNodes nodes =
          merge_into_cells(mapped(patch.measured, map), mapped(patch.surface.points, map),
                           patch.surface.normals, patch.weights, {}, 0.21 * unit, 1, {});
      EXPECT_EQ(nodes.of, plain.of) << unit << " " << far;
      EXPECT_LE(max_difference(nodes.places, mapped(plain.places, map)),
                1e-15 * unit * (1 + 10 * far));
    }
  }
}

TEST(SurfaceNodes, DoNotDependOnTheOrderOrTheThreads) {
  const Patch patch;
  const SurfaceNodes plain = patch.merged(0.3, {.threads = 1});
  EXPECT_EQ(patch.merged(0.3, {.threads = 5}).of, plain.of);
  EXPECT_EQ(patch.merged(0.3, {.threads = 5}).places, plain.places);
  Patch shuffled;
  const std::vector<std::uint32_t> order = random_permutation(2000, 3);
  for (std::size_t i = 0; i < 2000; ++i) {
    shuffled.measured[i] = patch.measured[order[i]];
    shuffled.surface.points[i] = patch.surface.points[order[i]];
    shuffled.surface.normals[i] = patch.surface.normals[order[i]];
    shuffled.weights[i] = patch.weights[order[i]];
  }
  const SurfaceNodes nodes = shuffled.merged(0.3);
  EXPECT_LE(max_difference(nodes.places, plain.places), 1e-14);
  EXPECT_EQ(nodes.weights, plain.weights);
  for (std::size_t i = 0; i < 2000; ++i) ASSERT_EQ(nodes.of[i], plain.of[order[i]]);
}

TEST(SurfaceNodes, MakeOneOfEqualPoints) {
  const std::vector<Vec3> points(50, {0.1, 0.2, 0.3});
  const SurfaceNodes nodes = merge_into_cells(points, points, {}, {}, {}, 1e-3, 1, {});
  ASSERT_EQ(nodes.size(), 1U);
  EXPECT_EQ(nodes.weights[0], 50);
  EXPECT_LE(norm(nodes.places[0] - points[0]), 1e-15);
}

// Cells are not wider for the room between two clouds.
TEST(SurfaceNodes, AreAsManyOfCloudsFarApart) {
  Patch patch;
  const SurfaceNodes alone = patch.merged(0.0625);
  EXPECT_GT(alone.size(), 1000U);
  for (const double far : {0x1p10, 0x1p20, 0x1p25}) {
    std::vector<Vec3> points = patch.surface.points;
    std::vector<Vec3> normals = patch.surface.normals;
    for (std::size_t i = 0; i < 2000; ++i) {
      points.push_back(points[i] + Vec3{far, 0, -far});
      normals.push_back(normals[i]);
    }
    const auto nodes = merge_into_cells(points, points, normals, {}, {}, 0.0625, 1, {}).size();
    EXPECT_NEAR(static_cast<double>(nodes), 2.0 * static_cast<double>(alone.size()), 100) << far;
  }
}

// Far more cells than could be numbered.
TEST(SurfaceNodes, StandCellsOfAnySize) {
  const Patch patch;
  EXPECT_EQ(patch.merged(1e-30).size(), 2000U);
  EXPECT_LE(patch.merged(1e30).size(), 6U);
}

}  // namespace
}  // namespace deburr

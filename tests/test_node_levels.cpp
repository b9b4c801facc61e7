// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "node_levels.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

/// Levels of 18 x 18 points at distance 1, with trusts that repeat.
NodeLevels levels_of_grid(double noise, std::vector<double> trusts = {1}) {
  const Sampled plane = plane_grid(18);
  std::vector<double> trust;
  for (std::size_t i = 0; i < plane.points.size(); ++i) trust.push_back(trusts[i % trusts.size()]);
  return {nodes_of_points(plane.points, plane.points, plane.normals, trust), 1, noise};
}

TEST(NodeLevels, MergeNineNodesIntoOne) {
  const NodeLevels levels = levels_of_grid(0.1);
  EXPECT_EQ(levels.spacing(), 1);
  EXPECT_EQ(levels.nodes(0).size(), 324U);
  EXPECT_EQ(levels.nodes(1).size(), 36U);
  EXPECT_EQ(levels.nodes(2).size(), 4U);
  EXPECT_EQ(levels.merged(0), 1);
  EXPECT_EQ(levels.merged(1), 9);
  EXPECT_EQ(levels.merged(2), 81);
  for (std::size_t level = 1; level < node_levels; ++level) {
    for (const double weight : levels.nodes(level).weights) {
      EXPECT_NEAR(weight, levels.merged(level), 1e-12);
    }
    for (const double trust : levels.nodes(level).trust) EXPECT_NEAR(trust, 1, 1e-15);
  }
}

TEST(NodeLevels, HaveTreesOfTheirNodes) {
  const NodeLevels levels = levels_of_grid(0.1);
  for (std::size_t level = 0; level < node_levels; ++level) {
    const std::vector<Vec3>& places = levels.nodes(level).places;
    EXPECT_EQ(levels.tree(level).order().size(), places.size());
    EXPECT_EQ(levels.tree(level).nearest_to(places.back()).index, places.size() - 1);
  }
}

// As long as cells are smaller than the noise, nodes are no surer than those of the next level.
TEST(NodeLevels, HaveCellsNoSmallerThanTheNoise) {
  const NodeLevels levels = levels_of_grid(6);
  EXPECT_EQ(levels.nodes(1).size(), 9U);
  EXPECT_EQ(levels.nodes(2).size(), 1U);
}

// A mean with the weights t has the variance (sum of t^2) / (sum of t)^2, over any number of
// levels.
TEST(NodeLevels, CountPointsOfFractionalTrust) {
  const std::vector<double> trusts{1, 0.25, 0.5, 0.02, 0.7};
  const NodeLevels levels = levels_of_grid(0.1, trusts);
  std::vector<std::uint32_t> of(324);
  for (std::uint32_t i = 0; i < 324; ++i) of[i] = i;
  for (std::size_t level = 1; level < node_levels; ++level) {
    const SurfaceNodes& nodes = levels.nodes(level);
    for (std::uint32_t& node : of) node = nodes.of[node];
    std::vector<double> total(nodes.size());
    std::vector<double> square(nodes.size());
    std::vector<Vec3> places(nodes.size());
    for (std::size_t i = 0; i < 324; ++i) {
      const double t = trusts[i % trusts.size()];
      total[of[i]] += t;
      square[of[i]] += t * t;
      places[of[i]] += t * levels.nodes(0).places[i];
    }
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      EXPECT_NEAR(nodes.weights[k], total[k] * total[k] / square[k], 1e-12);
      EXPECT_NEAR(nodes.weights[k] * nodes.trust[k], total[k], 1e-12);
      EXPECT_LT(norm(nodes.places[k] - (1 / total[k]) * places[k]), 1e-12);
    }
  }
}

// Both sides of a ridge along y at 63 degrees; their normals have the same largest component.
TEST(NodeLevels, KeepTwoFacesApart) {
  const double c = 0.8507;
  const double s = std::sqrt(1 - c * c);
  Sampled roof;
  for (const Vec3& p : plane_grid(36).points) {
    const double x = p.x - 17.5;
    roof.points.push_back({c * x, p.y, -s * std::abs(x)});
    roof.normals.push_back({x > 0 ? s : -s, 0, c});
  }
  const auto mixed = [&](const SurfaceNodes& nodes) {
    std::size_t count = 0;
    for (const Vec3& n : nodes.normals) count += std::abs(std::abs(n.x) - s) > 1e-9 ? 1 : 0;
    return count;
  };
  const NodeLevels levels(nodes_of_points(roof.points, roof.points, roof.normals), 1, 0.1);
  EXPECT_LT(levels.nodes(2).size(), 60U);
  for (std::size_t level = 0; level < node_levels; ++level) {
    EXPECT_EQ(mixed(levels.nodes(level)), 0U) << level;
  }
  EXPECT_GT(mixed(merge_into_cells(roof.points, roof.points, roof.normals, {}, {}, 9, 1, {})), 0U);
}

TEST(NodeLevels, StandOneNode) {
  const std::vector<Vec3> one{{1, 2, 3}};
  const NodeLevels levels(nodes_of_points(one, one, {}), 1, 0.1);
  for (std::size_t level = 0; level < node_levels; ++level) {
    EXPECT_EQ(levels.nodes(level).size(), 1U);
    EXPECT_EQ(levels.merged(level), 1);
  }
}

}  // namespace
}  // namespace deburr

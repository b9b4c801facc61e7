// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "automatic_parts.hpp"
#include "deburr/synth.hpp"
#include "node_levels.hpp"
#include "support/shapes.hpp"

// Switches that leave parts of the default method out do so, and none is off unless asked for.

namespace deburr {
namespace {

using Points3 = std::vector<Vec3>;

constexpr AutomaticParts everything{true, true, true, true, true, true,
                                    3,    true, true, true, true, true};
static_assert(everything.levels == node_levels);

/// A cube whose noise grows fivefold from one side to the other: of several levels, with edges.
PointCloud uneven_cube() {
  const SyntheticScan scan = synthesize(Shape::Cube, {.points = 1500, .noise = 0, .seed = 3});
  const auto [low, high] = std::ranges::minmax(scan.clean, {}, &Vec3::x);
  PointCloud cloud;
  Random random(2);
  for (const Vec3& p : scan.clean) {
    const double sigma = scan.spacing * (0.2 + 0.8 * (p.x - low.x) / (high.x - low.x));
    const Vec3 step{random.gaussian(), random.gaussian(), random.gaussian()};
    cloud.points.push_back(p + sigma * step);
  }
  return cloud;
}

TEST(AutomaticParts, AreAllThereUnlessLeftOut) {
  const PointCloud cloud = uneven_cube();
  const Points3 all = denoise_with(everything, cloud).cloud.points;
  EXPECT_EQ(denoise(cloud).cloud.points, all);
  EXPECT_EQ(denoise_with({}, cloud).cloud.points, all);
}

TEST(AutomaticParts, EachChangesTheResult) {
  const PointCloud cloud = uneven_cube();
  const Points3 all = denoise(cloud).cloud.points;
  const auto changes = [&](const std::string& name, const auto& leave_out) {
    AutomaticParts parts;
    leave_out(parts);
    const Points3 some = denoise_with(parts, cloud).cloud.points;
    EXPECT_NE(some, all) << name;
    EXPECT_NE(some, cloud.points) << name;
  };
  changes("fits", [](AutomaticParts& p) { p.fits = false; });
  changes("second_pass", [](AutomaticParts& p) { p.second_pass = false; });
  changes("pool", [](AutomaticParts& p) { p.pool = false; });
  changes("cloud_misfit", [](AutomaticParts& p) { p.cloud_misfit = false; });
  changes("local_sigma", [](AutomaticParts& p) { p.local_sigma = false; });
  changes("guards", [](AutomaticParts& p) { p.guards = false; });
  changes("levels 2", [](AutomaticParts& p) { p.levels = 2; });
  changes("levels 1", [](AutomaticParts& p) { p.levels = 1; });
  changes("surer_sheet", [](AutomaticParts& p) { p.surer_sheet = false; });
  changes("blend", [](AutomaticParts& p) { p.blend = false; });
  changes("creases", [](AutomaticParts& p) { p.creases = false; });
  changes("shares", [](AutomaticParts& p) { p.shares = false; });
  changes("noise_levels", [](AutomaticParts& p) { p.noise_levels = false; });
}

// Without creases sheets run on past edges, so that no point is labelled.
TEST(AutomaticParts, KnowNoEdgesWithoutCreases) {
  const PointCloud cloud = uneven_cube();
  const auto edges = [&](const AutomaticParts& parts) {
    const Report report = denoise_with(parts, cloud).report;
    return report.labels[static_cast<std::size_t>(Feature::Edge)];
  };
  EXPECT_GT(edges({}), 50U);
  EXPECT_EQ(edges({.creases = false}), 0U);
  EXPECT_EQ(edges({.fits = false}), 0U);
}

// On a flat face the largest fits take off most.
TEST(AutomaticParts, TakeLessNoiseOffWithFewerLevels) {
  const Points3 noisy = with_noise(plane_grid(50).points, 0.5, 4);
  const auto error = [&](std::size_t levels) {
    double sum = 0;
    PointCloud cloud;
    cloud.points = noisy;
    for (const Vec3& p : denoise_with({.levels = levels}, cloud).cloud.points) {
      sum += std::abs(p.z);
    }
    return sum / static_cast<double>(noisy.size());
  };
  const double two = error(2);
  EXPECT_LT(error(3), 0.8 * two);
  EXPECT_LT(two, 0.8 * error(1));
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/denoise_laws.hpp"

// What the result of the default method may depend on of given normals, and what not.

namespace deburr {
namespace {

TEST(DenoiseNormalLaws, DoesNotDependOnTheOrderOfPointsWithNormals) {
  const Sampled truth = cube(1500, 10);
  const std::vector<Vec3> points = with_noise(truth.points, 0.04, 11);
  const std::vector<Vec3> normals = tilted(truth.normals, 0.3, 12);
  const std::vector<std::uint32_t> order = random_permutation(points.size(), 13);
  const DenoiseResult plain = run(points, normals);
  const DenoiseResult shuffled = run(picked(points, order), picked(normals, order));
  EXPECT_TRUE(same_values(shuffled.cloud.points, picked(plain.cloud.points, order)));
  EXPECT_TRUE(same_values(shuffled.cloud.normals, picked(plain.cloud.normals, order)));
  EXPECT_TRUE(plain.report.kept_normals);
}

TEST(DenoiseNormalLaws, DoesNotDependOnTheSignsOfTheNormals) {
  const Sampled truth = cube(1500, 14);
  const std::vector<Vec3> points = with_noise(truth.points, 0.04, 15);
  const std::vector<Vec3> normals = tilted(truth.normals, 0.3, 16);
  const DenoiseResult plain = run(points, normals);
  for (unsigned seed = 17; seed < 20; ++seed) {
    expect_same_result(run(points, with_random_signs(normals, seed)), plain);
  }
}

/// Exactly perpendicular neighbours: no sign can be passed on between the faces of a cube.
TEST(DenoiseNormalLaws, DoesNotDependOnTheSignsOfPerpendicularNormals) {
  const Sampled exact = cube(1500, 1);
  const std::vector<Vec3> points = with_noise(exact.points, 0.01, 2);
  expect_same_result(run(points, with_random_signs(exact.normals, 3)),
                     run(points, with_random_signs(exact.normals, 4)));
}

TEST(DenoiseNormalLaws, EstimatesTheNormalsThatAreMissing) {
  const std::vector<Vec3> points = noisy_cube();
  const std::vector<Vec3> none(points.size());
  const std::vector<Vec3> broken(points.size(), Vec3{not_a_number, 0, 1});
  const DenoiseResult estimated = run(points);
  expect_same_result(run(points, none), estimated);
  expect_same_result(run(points, broken), estimated);
}

TEST(DenoiseNormalLaws, DoesNotDependOnTheOrderOfDuplicatesWithOtherNormals) {
  const Sampled exact = cube(800, 1);
  std::vector<Vec3> points = with_noise(exact.points, 0.02, 2);
  std::vector<Vec3> normals = exact.normals;
  points.insert(points.end(), points.begin(), points.begin() + 800);
  const std::vector<Vec3> others = tilted(exact.normals, 0.3, 5);
  normals.insert(normals.end(), others.begin(), others.end());
  DenoiseResult there = run(points, normals);
  std::ranges::reverse(points);
  std::ranges::reverse(normals);
  const DenoiseResult back = run(points, normals);
  std::ranges::reverse(there.cloud.points);
  EXPECT_EQ(there.cloud.points, back.cloud.points);
}

}  // namespace
}  // namespace deburr

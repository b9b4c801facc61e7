// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

#include "deburr/denoise.hpp"
#include "support/compare.hpp"
#include "support/same_cloud.hpp"
#include "support/shapes.hpp"

// What the result of the default method may depend on, and what not.

namespace deburr {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

DenoiseResult run(std::vector<Vec3> points, std::vector<Vec3> normals = {},
                  const Execution& execution = {}) {
  PointCloud cloud;
  cloud.points = std::move(points);
  cloud.normals = std::move(normals);
  return denoise(cloud, {}, execution);
}

/// The noise is a third of the spacing.
std::vector<Vec3> noisy_cube() { return with_noise(cube(1500, 1).points, 0.04, 2); }

template <typename Value>
std::vector<Value> picked(const std::vector<Value>& values, std::span<const std::uint32_t> order) {
  std::vector<Value> result;
  for (const std::uint32_t i : order) result.push_back(values[i]);
  return result;
}

void expect_same_result(const DenoiseResult& a, const DenoiseResult& b) {
  EXPECT_TRUE(same_values(a.cloud.points, b.cloud.points));
  EXPECT_TRUE(same_values(a.cloud.normals, b.cloud.normals));
  EXPECT_TRUE(same_values(a.displacement, b.displacement));
  EXPECT_EQ(a.labels, b.labels);
}

TEST(DenoiseLaws, CommutesWithRigidMotions) {
  const std::vector<Vec3> points = noisy_cube();
  const DenoiseResult still = run(points);
  for (unsigned seed = 3; seed < 6; ++seed) {
    const Rotation turn = random_rotation(seed);
    const Vec3 shift = 3.0 * random_directions(1, seed)[0];
    const auto motion = [&](const Vec3& p) { return turn(p) + shift; };
    const DenoiseResult moved = run(mapped(points, motion));
    EXPECT_LE(max_difference(moved.cloud.points, mapped(still.cloud.points, motion)), 1e-10);
    EXPECT_LE(max_difference_of_lines(moved.cloud.normals, mapped(still.cloud.normals, turn)),
              1e-9);
    EXPECT_EQ(moved.labels, still.labels);
  }
}

TEST(DenoiseLaws, CommutesExactlyWithPowersOfTwo) {
  const std::vector<Vec3> points = noisy_cube();
  const DenoiseResult plain = run(points);
  for (const double unit : {0x1p-40, 0.5, 0x1p+30}) {
    const auto scale = [&](const Vec3& p) { return unit * p; };
    const DenoiseResult scaled = run(mapped(points, scale));
    EXPECT_EQ(scaled.cloud.points, mapped(plain.cloud.points, scale));
    EXPECT_EQ(scaled.cloud.normals, plain.cloud.normals);
    EXPECT_EQ(scaled.labels, plain.labels);
    EXPECT_EQ(scaled.report.noise, unit * plain.report.noise);
    EXPECT_EQ(scaled.report.spacing, unit * plain.report.spacing);
    EXPECT_EQ(scaled.report.max_move, unit * plain.report.max_move);
  }
}

TEST(DenoiseLaws, CommutesWithTheUnit) {
  const std::vector<Vec3> points = noisy_cube();
  const DenoiseResult plain = run(points);
  for (const double unit : {1e-6, 1e6}) {
    const auto scale = [&](const Vec3& p) { return unit * p; };
    const DenoiseResult scaled = run(mapped(points, scale));
    EXPECT_LE(max_difference(scaled.cloud.points, mapped(plain.cloud.points, scale)),
              1e-9 * scaled.report.spacing);
    EXPECT_EQ(scaled.labels, plain.labels);
  }
}

// The shift itself takes 1e-9 spacings from the coordinates.
TEST(DenoiseLaws, HoldsFarFromTheOrigin) {
  const std::vector<Vec3> points = noisy_cube();
  const DenoiseResult plain = run(points);
  const double far = 1e7 * plain.report.spacing;
  const auto shift = [&](const Vec3& p) { return p + Vec3{far, -far, far}; };
  const DenoiseResult shifted = run(mapped(points, shift));
  EXPECT_LE(max_difference(shifted.cloud.points, mapped(plain.cloud.points, shift)),
            1e-6 * plain.report.spacing);
}

TEST(DenoiseLaws, DoesNotDependOnTheOrderOfThePoints) {
  std::vector<Vec3> points = noisy_cube();
  points.insert(points.end(), points.begin(), points.begin() + 300);  // duplicates as well
  points.push_back({not_a_number, 0, 0});
  const DenoiseResult plain = run(points);
  for (unsigned seed = 7; seed < 10; ++seed) {
    const std::vector<std::uint32_t> order = random_permutation(points.size(), seed);
    DenoiseResult expected = plain;
    expected.cloud.points = picked(plain.cloud.points, order);
    expected.cloud.normals = picked(plain.cloud.normals, order);
    expected.displacement = picked(plain.displacement, order);
    expected.labels = picked(plain.labels, order);
    expect_same_result(run(picked(points, order)), expected);
  }
}

TEST(DenoiseLaws, DoesNotDependOnTheOrderOfPointsWithNormals) {
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

TEST(DenoiseLaws, DoesNotDependOnTheSignsOfTheNormals) {
  const Sampled truth = cube(1500, 14);
  const std::vector<Vec3> points = with_noise(truth.points, 0.04, 15);
  const std::vector<Vec3> normals = tilted(truth.normals, 0.3, 16);
  const DenoiseResult plain = run(points, normals);
  for (unsigned seed = 17; seed < 20; ++seed) {
    expect_same_result(run(points, with_random_signs(normals, seed)), plain);
  }
}

/// Exactly perpendicular neighbours: no sign can be passed on between the faces of a cube.
TEST(DenoiseLaws, DoesNotDependOnTheSignsOfPerpendicularNormals) {
  const Sampled exact = cube(1500, 1);
  const std::vector<Vec3> points = with_noise(exact.points, 0.01, 2);
  expect_same_result(run(points, with_random_signs(exact.normals, 3)),
                     run(points, with_random_signs(exact.normals, 4)));
}

TEST(DenoiseLaws, EstimatesTheNormalsThatAreMissing) {
  const std::vector<Vec3> points = noisy_cube();
  const std::vector<Vec3> none(points.size());
  const std::vector<Vec3> broken(points.size(), Vec3{not_a_number, 0, 1});
  const DenoiseResult estimated = run(points);
  expect_same_result(run(points, none), estimated);
  expect_same_result(run(points, broken), estimated);
}

TEST(DenoiseLaws, DoesNotDependOnTheOrderOfDuplicatesWithOtherNormals) {
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

TEST(DenoiseLaws, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Vec3> points = noisy_cube();
  const DenoiseResult one = run(points, {}, {.threads = 1});
  for (const int threads : {2, 3, 7})
    expect_same_result(run(points, {}, {.threads = threads}), one);
}

TEST(DenoiseLaws, MovesDuplicatesTogetherAsIfTheyWereOnePoint) {
  const std::vector<Vec3> points = noisy_cube();
  const DenoiseResult single = run(points);
  std::vector<Vec3> doubled = points;
  for (std::size_t i = 0; i < points.size(); i += 3) {
    doubled.insert(doubled.end(), 1 + i % 4, points[i]);
  }
  const DenoiseResult result = run(doubled);
  EXPECT_EQ(result.report.duplicates, doubled.size() - points.size());
  std::size_t at = points.size();
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_EQ(result.cloud.points[i], single.cloud.points[i]);
    if (i % 3 != 0) continue;
    for (std::size_t copy = 0; copy < 1 + i % 4; ++copy, ++at) {
      ASSERT_EQ(result.cloud.points[at], single.cloud.points[i]);
      ASSERT_EQ(result.labels[at], single.labels[i]);
    }
  }
}

TEST(DenoiseLaws, PassesPointsThatAreNotFiniteBy) {
  const std::vector<Vec3> points = noisy_cube();
  const DenoiseResult without = run(points);
  const std::vector<Vec3> bad{
      {not_a_number, 1, 2}, {1, infinity, 2}, {1, 2, -infinity}, {-0.0, 0.1, not_a_number}};
  std::vector<Vec3> mixed = points;
  mixed.insert(mixed.begin(), bad[0]);
  mixed.insert(mixed.begin() + 1000, {bad[1], bad[2]});
  mixed.push_back(bad[3]);
  const DenoiseResult with = run(mixed);
  EXPECT_EQ(with.report.non_finite, 4U);
  std::vector<std::uint32_t> good;
  for (std::uint32_t i = 0; i < mixed.size(); ++i) {
    if (is_finite(mixed[i])) {
      good.push_back(i);
      continue;
    }
    EXPECT_TRUE(same_bits(with.cloud.points[i], mixed[i]));
    EXPECT_EQ(with.labels[i], Feature::Isolated);
    EXPECT_EQ(with.displacement[i], 0);
  }
  EXPECT_TRUE(same_values(picked(with.cloud.points, good), without.cloud.points));
  EXPECT_TRUE(same_values(picked(with.cloud.normals, good), without.cloud.normals));
  EXPECT_EQ(picked(with.labels, good), without.labels);
}

TEST(DenoiseLaws, LeavesLonePointsAsTheyAre) {
  std::vector<Vec3> points = noisy_cube();
  const std::vector<Vec3> lone{{7.1, -0.0, 0.1}, {-9.3, 8.7, 0}, {1.0 / 3, 12.1, -6.7}};
  points.insert(points.end(), lone.begin(), lone.end());
  const DenoiseResult result = run(points);
  for (std::size_t k = 0; k < lone.size(); ++k) {
    const std::size_t i = points.size() - lone.size() + k;
    EXPECT_TRUE(same_bits(result.cloud.points[i], lone[k]));
    EXPECT_EQ(result.labels[i], Feature::Isolated);
    EXPECT_EQ(result.displacement[i], 0);
  }
}

}  // namespace
}  // namespace deburr

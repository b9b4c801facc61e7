// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "deburr/synth.hpp"
#include "support/compare.hpp"
#include "support/denoise_laws.hpp"

// What the result of the default method may depend on, and what not.

namespace deburr {
namespace {

// Its grids follow the axes and the noise is sampled along a curve through space: a turned cloud
// comes out a little differently, but no worse.
TEST(DenoiseLaws, GivesATurnedCloudAsGoodAResult) {
  const auto error = [](Points places) {
    return mean_of(places.size(), [&](std::size_t i) { return distance_to_cube(places[i]); });
  };
  constexpr int clouds = 4;
  constexpr int turns = 3;
  double before = 0;
  double after = 0;
  for (unsigned cloud = 1; cloud <= clouds; ++cloud) {
    const std::vector<Vec3> points = with_noise(cube(1500, cloud).points, 0.04, cloud + 1);
    const DenoiseResult still = run(points);
    const double unturned = error(still.cloud.points);
    before += unturned / clouds;
    for (unsigned seed = 3; seed < 3 + turns; ++seed) {
      const Rotation turn = random_rotation(seed);
      const Vec3 shift = 3.0 * random_directions(1, seed)[0];
      const auto back = [&](const Vec3& p) {
        const Vec3 q = p - shift;
        return q.x * turn.rows[0] + q.y * turn.rows[1] + q.z * turn.rows[2];
      };
      const DenoiseResult turned =
          run(mapped(points, [&](const Vec3& p) { return turn(p) + shift; }));
      const std::vector<Vec3> places = mapped(turned.cloud.points, back);
      after += error(places) / (clouds * turns);
      // Among so few points chance makes 0.93 to 1.26 of it.
      EXPECT_LT(error(places), 1.3 * unturned) << cloud << ' ' << seed;
      const double square = mean_of(
          1500, [&](std::size_t i) { return squared_norm(places[i] - still.cloud.points[i]); });
      // 0.42 to 0.48: near an edge another sheet may win, and other nodes have fits of their own.
      EXPECT_LT(std::sqrt(square), 0.55 * 0.04) << cloud << ' ' << seed;
      EXPECT_NEAR(turned.report.noise, still.report.noise, 0.03 * still.report.noise)
          << cloud << ' ' << seed;
    }
  }
  EXPECT_NEAR(after, before, 0.1 * before);
}

TEST(DenoiseLaws, CommutesWithAShift) {
  const std::vector<Vec3> points = noisy_cube();
  const DenoiseResult still = run(points);
  const auto shift = [](const Vec3& p) { return p + Vec3{0.3, -11.7, 5.1}; };
  const DenoiseResult shifted = run(mapped(points, shift));
  EXPECT_LE(max_difference(shifted.cloud.points, mapped(still.cloud.points, shift)), 1e-10);
  EXPECT_EQ(shifted.labels, still.labels);
  EXPECT_EQ(shifted.outliers, still.outliers);
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

// Groups of two points are many there, and both are as near to the mean of them.
TEST(DenoiseLaws, CommutesWithTheUnitWherePointsAreMerged) {
  for (const std::uint64_t seed : {5U, 8U, 10U}) {
    const std::vector<Vec3> points =
        synthesize_part(
            {.points = 1500, .noise = 0.8, .noise_unit = NoiseUnit::Spacing, .seed = seed})
            .cloud.points;
    const auto scale = [](const Vec3& p) { return 1e-6 * p; };
    const DenoiseResult plain = run(points);
    const DenoiseResult scaled = run(mapped(points, scale));
    EXPECT_LE(max_difference(scaled.cloud.points, mapped(plain.cloud.points, scale)),
              1e-6 * scaled.report.spacing)
        << seed;
    EXPECT_EQ(scaled.labels, plain.labels) << seed;
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
    expected.outliers = picked(plain.outliers, order);
    expect_same_result(run(picked(points, order)), expected);
  }
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
    EXPECT_EQ(result.outliers[i], 1);
  }
  EXPECT_EQ(result.report.outliers, lone.size());
}

}  // namespace
}  // namespace deburr

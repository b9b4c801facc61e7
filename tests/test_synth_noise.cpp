// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "deburr/metrics.hpp"
#include "deburr/synth.hpp"
#include "support/compare.hpp"
#include "triangle_bvh.hpp"

namespace deburr {
namespace {

constexpr std::size_t n = 40000;
constexpr Shape shape = Shape::Part;

/// The displacement of each point in standard deviations of the noise.
std::vector<Vec3> displacements(const SyntheticScan& scan) {
  std::vector<Vec3> moved;
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    moved.push_back((1 / scan.sigma) * (scan.cloud.points[i] - scan.clean[i]));
  }
  return moved;
}

/// Mean of the first, second and fourth power.
std::array<double, 3> moments(const std::vector<double>& values) {
  const auto mean = [&](double power) {
    return mean_of(values.size(), [&](std::size_t i) { return std::pow(values[i], power); });
  };
  return {mean(1), mean(2), mean(4)};
}

// Four standard errors.
const double error = 4 / std::sqrt(static_cast<double>(n));

void expect_normal_distribution(const std::vector<double>& values) {
  const auto [mean, square, fourth] = moments(values);
  EXPECT_NEAR(mean, 0, error);
  EXPECT_NEAR(square, 1, std::sqrt(2.0) * error);
  EXPECT_NEAR(fourth, 3, std::sqrt(96.0) * error);
}

SyntheticScan scan_with(NoiseKind kind) {
  return synthesize(shape, {.points = n, .noise = 0.01, .noise_kind = kind, .seed = 6});
}

TEST(SynthNoise, IsotropicIsNormalAlongEveryAxis) {
  const SyntheticScan scan = scan_with(NoiseKind::Isotropic);
  const std::vector<Vec3> moved = displacements(scan);
  for (const auto axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    std::vector<double> values;
    for (const Vec3& d : moved) values.push_back(d.*axis);
    expect_normal_distribution(values);
  }
}

TEST(SynthNoise, NormalKeepsToTheNormal) {
  const SyntheticScan scan = scan_with(NoiseKind::Normal);
  const std::vector<Vec3> moved = displacements(scan);
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_LT(norm(cross(moved[i], scan.normals[i])), 1e-12);
    values.push_back(dot(moved[i], scan.normals[i]));
  }
  expect_normal_distribution(values);
}

TEST(SynthNoise, ImpulsiveLeavesHalfOfThePointsAndHasTheSameRms) {
  const SyntheticScan scan = scan_with(NoiseKind::Impulsive);
  const std::vector<Vec3> moved = displacements(scan);
  std::vector<double> values;
  double rms = 0;
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_LT(norm(cross(moved[i], scan.normals[i])), 1e-12);
    if (moved[i] == Vec3{}) continue;
    values.push_back(dot(moved[i], scan.normals[i]) / std::numbers::sqrt2);
    rms += squared_norm(moved[i]) / n;
  }
  EXPECT_NEAR(static_cast<double>(values.size()) / n, 0.5, 0.5 * error);
  const auto [mean, square, fourth] = moments(values);
  EXPECT_NEAR(mean, 0, 1.5 * error);
  EXPECT_NEAR(square, 1, 2 * error);
  EXPECT_NEAR(fourth, 3, 14 * error);
  // The variance of the square is 5, that of a mixture of 0 and N(0, 2).
  EXPECT_NEAR(rms, 1, std::sqrt(5.0) * error);
}

// The scanner that docs/synth.md names: one and a half diagonals from the middle of the box.
TEST(SynthNoise, RayKeepsToTheRayFromTheScanner) {
  const SyntheticScan scan = scan_with(NoiseKind::Ray);
  const std::vector<Vec3> moved = displacements(scan);
  const Vec3 centre{50, 30, 20};
  const double diagonal = std::sqrt(100.0 * 100 + 60 * 60 + 40 * 40);
  const Vec3 scanner = centre + 1.5 * diagonal / std::sqrt(3.0) * Vec3{1, 1, 1};
  std::vector<double> values;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 ray = scan.clean[i] - scanner;
    ASSERT_LT(norm(cross(moved[i], ray)), 1e-10 * norm(ray));
    values.push_back(dot(moved[i], ray) / norm(ray));
  }
  expect_normal_distribution(values);
}

// A scanned point lies on a ray of the scanner that saw it, before and after the noise.
TEST(SynthNoise, RayOfAScanIsThatOfItsScanner) {
  const SyntheticScan scan = synthesize(
      Shape::Cube,
      {.points = 2000, .noise = 0.01, .noise_kind = NoiseKind::Ray, .sampling = Sampling::Scanner});
  std::array<int, 4> seen{};
  std::size_t last = 0;
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    const Vec3 moved = scan.cloud.points[i] - scan.clean[i];
    int along = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      // One and a half diagonals of the unit cube are 1.5 times the vector (1, 1, 1).
      const std::array<Vec3, 4> corners{Vec3{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}};
      const Vec3 ray = scan.clean[i] - (Vec3{0.5, 0.5, 0.5} + 1.5 * corners.at(k));
      if (norm(cross(moved, ray)) > 1e-13) continue;
      ++along;
      ++seen.at(k);
      ASSERT_GE(k, last) << i;  // one scanner after the other
      last = k;
    }
    ASSERT_EQ(along, 1) << i;
  }
  for (const int count : seen) EXPECT_GT(count, 300);
}

TEST(SynthNoise, ASeedStandsForTheSamePlacesAtAnyNoise) {
  for (const Sampling sampling : {Sampling::Uniform, Sampling::Poisson, Sampling::Scanner}) {
    const SynthOptions clean{.points = 500, .noise = 0, .sampling = sampling};
    const std::vector<Vec3> expected = synthesize(shape, clean).cloud.points;
    for (const NoiseKind kind :
         {NoiseKind::Isotropic, NoiseKind::Normal, NoiseKind::Impulsive, NoiseKind::Ray}) {
      SynthOptions noisy = clean;
      noisy.noise = 0.02;
      noisy.noise_kind = kind;
      EXPECT_EQ(synthesize(shape, noisy).clean, expected);
    }
  }
}

TEST(SynthNoise, UnitsAreTheDiagonalAndTheSpacing) {
  const SyntheticScan a = synthesize(Shape::Cube, {.points = 600, .noise = 0.1});
  EXPECT_DOUBLE_EQ(a.spacing, 0.1);  // 6 / 600 is its square
  EXPECT_DOUBLE_EQ(a.sigma, 0.1 * std::sqrt(3.0));
  const SyntheticScan b = synthesize(
      Shape::Cube, {.points = 600, .noise = std::sqrt(3.0), .noise_unit = NoiseUnit::Spacing});
  EXPECT_DOUBLE_EQ(b.sigma, a.sigma);
  EXPECT_LT(max_difference(a.cloud.points, b.cloud.points), 1e-14);
}

TEST(SynthNoise, TruthIsOnTheSurfaceWithTheNormalsOfItsTriangles) {
  for (const Sampling sampling : {Sampling::Uniform, Sampling::Poisson, Sampling::Scanner}) {
    const SyntheticScan scan =
        synthesize(Shape::Cube, {.points = 1000, .noise = 0.05, .sampling = sampling});
    EXPECT_LT(compare_to_surface(scan.clean, scan.truth).maximum, 1e-15);
    EXPECT_TRUE(scan.cloud.normals.empty());
    EXPECT_TRUE(scan.cloud.attributes.empty());
    ASSERT_EQ(scan.normals.size(), 1000U);
    for (std::size_t i = 0; i < 1000; ++i) {
      const Vec3& p = scan.clean[i];
      const Vec3& normal = scan.normals[i];
      ASSERT_EQ(norm(normal), 1);
      // The coordinate that the normal points along is 1 where it points up, 0 where down.
      ASSERT_NEAR(dot(normal, p), dot(normal, Vec3{1, 1, 1}) > 0 ? 1 : 0, 1e-15);
      ASSERT_EQ(scan.outlier[i], 0);
    }
  }
}

}  // namespace
}  // namespace deburr

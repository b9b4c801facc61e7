// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "deburr/metrics.hpp"
#include "deburr/synth.hpp"
#include "random.hpp"

namespace deburr {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Random, LogarithmIsRightToAFewRoundings) {
  Random random(1);
  for (int i = 0; i < 100000; ++i) {
    const double u = random.uniform();
    for (const double x : {u, 1 - 1e-8 * u, std::ldexp(u, -1000 * i / 100000)}) {
      if (x == 0) continue;
      ASSERT_NEAR(Random::log(x), std::log(x), 5e-16 * std::abs(std::log(x))) << x;
    }
  }
  EXPECT_EQ(Random::log(1), 0);
}

// All bounds are four standard errors.
TEST(Random, GaussianHasTheMomentsAndTailsOfTheNormalDistribution) {
  constexpr int n = 1000000;
  Random random(2);
  std::array<double, 4> moments{};
  std::array<int, 4> beyond{};
  double lagged = 0;
  double previous = 0;
  for (int i = 0; i < n; ++i) {
    const double g = random.gaussian();
    for (int k = 0; k < 4; ++k) {
      moments.at(static_cast<std::size_t>(k)) += std::pow(g, k + 1) / n;
      if (std::abs(g) > k + 1) ++beyond.at(static_cast<std::size_t>(k));
    }
    lagged += g * previous / n;
    previous = g;
  }
  const double error = 4 / std::sqrt(n);
  EXPECT_NEAR(moments[0], 0, error);
  EXPECT_NEAR(moments[1], 1, std::sqrt(2.0) * error);
  EXPECT_NEAR(moments[2], 0, std::sqrt(15.0) * error);
  EXPECT_NEAR(moments[3], 3, std::sqrt(96.0) * error);
  EXPECT_NEAR(lagged, 0, error);
  for (int k = 0; k < 4; ++k) {
    const double expected = n * std::erfc((k + 1) / std::numbers::sqrt2);
    EXPECT_NEAR(beyond.at(static_cast<std::size_t>(k)), expected, 4 * std::sqrt(expected)) << k;
  }
}

TEST(SynthesizePart, HasTheSameBitsEverywhere) {
  const SyntheticScan scan = synthesize_part({.points = 1000, .noise = 0.01, .seed = 42});
  ASSERT_EQ(scan.cloud.size(), 1000U);
  EXPECT_TRUE(scan.cloud.normals.empty());
  EXPECT_EQ(scan.cloud.points[0],
            (Vec3{0x1.e366475878846p+5, 0x1.f19f313950856p+4, 0x1.e0adc8eb1db11p+3}));
  EXPECT_EQ(scan.cloud.points[1],
            (Vec3{0x1.e25ea0098ef35p+2, 0x1.3e2444928ba4ep+1, 0x1.740182b7b6d56p+4}));
  EXPECT_EQ(scan.cloud.points[999],
            (Vec3{0x1.06f5d04aad1aep+5, 0x1.d93af89729db9p+5, 0x1.1bfdfd4843dddp+4}));
  EXPECT_EQ(scan.truth.vertices[40], (Vec3{0x1.830ff7fce1703p+6, 0, 0x1.cd9f023f9c3a1p+3}));
}

TEST(SynthesizePart, DependsOnTheSeed) {
  const auto points = [](std::uint64_t seed) {
    return synthesize_part({.points = 100, .seed = seed}).cloud.points;
  };
  EXPECT_EQ(points(7), points(7));
  EXPECT_NE(points(7), points(8));
  EXPECT_NE(points(0), points(0xffffffffffffffff));
}

TEST(SynthesizePart, LiesOnTheSurfaceWithoutNoise) {
  const SyntheticScan scan = synthesize_part({.points = 20000, .noise = 0});
  const SurfaceError error = compare_to_surface(scan.cloud.points, scan.truth);
  EXPECT_LT(error.maximum, 1e-15 * error.diagonal);
}

TEST(SynthesizePart, AddsIsotropicNoiseToTheSamePlaces) {
  constexpr std::size_t n = 100000;
  const SyntheticScan clean = synthesize_part({.points = n, .noise = 0, .seed = 3});
  const SyntheticScan noisy = synthesize_part({.points = n, .noise = 0.02, .seed = 3});
  const double sigma = 0.02 * std::sqrt(100.0 * 100 + 60 * 60 + 40 * 40);
  Vec3 squares;
  Vec3 products;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 d = (1 / sigma) * (noisy.cloud.points[i] - clean.cloud.points[i]);
    squares += (1.0 / n) * Vec3{d.x * d.x, d.y * d.y, d.z * d.z};
    products += (1.0 / n) * Vec3{d.x * d.y, d.y * d.z, d.z * d.x};
  }
  // Four standard errors.
  const double error = 4 / std::sqrt(static_cast<double>(n));
  for (const double v : {squares.x, squares.y, squares.z}) {
    EXPECT_NEAR(v, 1, std::sqrt(2.0) * error);
  }
  for (const double v : {products.x, products.y, products.z}) EXPECT_NEAR(v, 0, error);
}

// The faces of the part and their areas, in mm; curves as smooth ones, 1e-4 from their polygons.
struct Face {
  const char* name;
  double area;
  bool (*has)(const Vec3&);
};
bool near(double a, double b) { return std::abs(a - b) < 2e-3; }
constexpr double pi = std::numbers::pi;
constexpr double profile = 2440 - 150 - 64 * (1 - pi / 4);
constexpr std::array<Face, 13> faces{{
    {"front", profile, [](const Vec3& p) { return near(p.y, 0); }},
    {"back", profile, [](const Vec3& p) { return near(p.y, 60); }},
    {"bottom", 6000 - 100 * pi, [](const Vec3& p) { return near(p.z, 0); }},
    {"left", 60 * 15, [](const Vec3& p) { return near(p.x, 0); }},
    {"right", 60 * 8, [](const Vec3& p) { return near(p.x, 100) && p.z < 8; }},
    {"slant", 60 * 25, [](const Vec3& p) { return p.x < 20 && near(3 * p.x - 4 * p.z, -60); }},
    {"top", 60 * 40 - 144 * pi, [](const Vec3& p) { return near(p.z, 30); }},
    {"riser", 60 * 14, [](const Vec3& p) { return near(p.x, 60) && p.z > 16; }},
    {"floor", 60 * 32 - 100 * pi, [](const Vec3& p) { return near(p.z, 16) && p.x < 92; }},
    {"fillet", 60 * 4 * pi,
     [](const Vec3& p) { return p.x > 92 && p.z > 8 && near(std::hypot(p.x - 92, p.z - 8), 8); }},
    {"hole", 16 * 20 * pi, [](const Vec3& p) { return near(std::hypot(p.x - 76, p.y - 30), 10); }},
    {"boss", 10 * 24 * pi,
     [](const Vec3& p) { return p.z > 30 && near(std::hypot(p.x - 40, p.y - 30), 12); }},
    {"boss top", 144 * pi, [](const Vec3& p) { return near(p.z, 40); }},
}};

TEST(SynthesizePart, SamplesEveryFaceByItsArea) {
  constexpr std::size_t n = 200000;
  const SyntheticScan scan = synthesize_part({.points = n, .noise = 0, .seed = 4});
  std::array<double, faces.size()> counts{};
  double total = 0;
  for (const Face& face : faces) total += face.area;
  for (const Vec3& p : scan.cloud.points) {
    std::size_t f = 0;
    while (f < faces.size() && !faces.at(f).has(p)) ++f;
    ASSERT_LT(f, faces.size()) << p.x << " " << p.y << " " << p.z;
    ++counts.at(f);
  }
  double chi_squared = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const double expected = n * faces.at(f).area / total;
    chi_squared += std::pow(counts.at(f) - expected, 2) / expected;
    EXPECT_NEAR(counts.at(f), expected, 5 * std::sqrt(expected)) << faces.at(f).name;
  }
  EXPECT_LT(chi_squared, 32.9);  // 12 degrees of freedom, 0.1 %
}

TEST(SynthesizePart, SamplesUniformlyWithinAFace) {
  const SyntheticScan scan = synthesize_part({.points = 200000, .noise = 0, .seed = 5});
  std::array<double, 16> counts{};  // of the slanted face, in 4 x 4 cells
  double total = 0;
  for (const Vec3& p : scan.cloud.points) {
    if (p.x >= 20 || !near(3 * p.x - 4 * p.z, -60) || near(p.y, 0) || near(p.y, 60)) continue;
    ++counts.at(static_cast<std::size_t>(p.x / 5) * 4 + static_cast<std::size_t>(p.y / 15));
    ++total;
  }
  double chi_squared = 0;
  for (const double count : counts) chi_squared += std::pow(count - total / 16, 2) / (total / 16);
  EXPECT_LT(chi_squared, 37.7);  // 15 degrees of freedom, 0.1 %
}

TEST(SynthesizePart, NamesTheWrongOption) {
  const auto message = [](const SynthOptions& options) -> std::string {
    try {
      (void)synthesize_part(options);
    } catch (const std::invalid_argument& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message({.points = 0}), "synth.points must be >= 1, got 0");
  EXPECT_EQ(message({.points = 1, .noise = -0.5}), "synth.noise must be finite and >= 0, got -0.5");
  EXPECT_EQ(message({.points = 1, .noise = nan}), "synth.noise must be finite and >= 0, got nan");
  EXPECT_EQ(message({.points = 1, .noise = std::numeric_limits<double>::infinity()}),
            "synth.noise must be finite and >= 0, got inf");
  EXPECT_EQ(message({.points = 1, .noise = 0}), "");
}

}  // namespace
}  // namespace deburr

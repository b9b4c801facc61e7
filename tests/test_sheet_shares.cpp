// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "random.hpp"
#include "sheet_shares.hpp"

namespace deburr {
namespace {

constexpr Vec3 up{0, 0, 1};
constexpr Vec3 ahead{1, 0, 0};
constexpr Vec3 left{0, 1, 0};

/// The shares of a point among faces through 0 with these normals, each on the inner side of all
/// others: side -1.
std::vector<double> shares(const Vec3& x, const std::vector<Vec3>& normals, double noise,
                           double side = -1) {
  std::vector<CutSheet> sheets;
  Sides sides{};
  for (std::size_t k = 0; k < normals.size(); ++k) {
    sheets.push_back({x - dot(normals[k], x) * normals[k], normals[k]});
    for (std::size_t j = 0; j < normals.size(); ++j) sides.at(j).at(k) = j == k ? 0 : side;
  }
  set_shares(x, sheets, sides, noise);
  std::vector<double> shares;
  for (const CutSheet& sheet : sheets) shares.push_back(sheet.share);
  return shares;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double v : values) total += v;
  return total;
}

/// The likelihood of x under the face z = 0, x < 0 with noise 1, exactly; times a constant.
double likelihood(double x, double z) {
  return std::exp(-z * z / 2) * 0.5 * std::erfc(x / std::numbers::sqrt2);
}

TEST(SheetShares, AreEqualAtEqualDistances) {
  for (const double h : {-2.0, -0.3, 0.0, 0.7, 3.0}) {
    const std::vector<double> two = shares({h, 5, h}, {up, ahead}, 1);
    EXPECT_NEAR(two[0], 0.5, 1e-15) << h;
    EXPECT_NEAR(two[1], 0.5, 1e-15) << h;
    for (const double share : shares({h, h, h}, {up, ahead, left}, 1)) {
      EXPECT_NEAR(share, 1.0 / 3, 1e-15) << h;
    }
  }
}

TEST(SheetShares, AreThoseOfTheLikelihoods) {
  for (double x = -4; x <= 3; x += 0.35) {
    for (double z = -4; z <= 3; z += 0.35) {
      const std::vector<double> found = shares({x, 0, z}, {up, ahead}, 1);
      const double top = likelihood(x, z);
      // The logistic approximation of the normal distribution is good to 2e-4; where both
      // likelihoods are small it is worth less.
      const double tolerance = x < 1 && z < 1 ? 1e-3 : 0.05;
      EXPECT_NEAR(found[0], top / (top + likelihood(z, x)), tolerance) << x << " " << z;
      EXPECT_NEAR(sum(found), 1, 1e-15);
    }
  }
}

TEST(SheetShares, AreWholeFarFromTheOtherSheet) {
  EXPECT_GT(shares({-6, 0, 0.5}, {up, ahead}, 1)[0], 1 - 1e-6);
  EXPECT_LT(shares({0.5, 0, -6}, {up, ahead}, 1)[0], 1e-6);
  EXPECT_EQ(shares({3, 2, 1}, {up}, 1), std::vector<double>{1});
}

/// Sums over noisy points of the face z = 0, x < 0 and another at an angle to it, uniformly
/// sampled.
struct EdgeSums {
  double soft = 0, soft_square = 0;  ///< of share times height over the first face
  double hard = 0, hard_square = 0;  ///< of the heights of those nearer to it

  explicit EdgeSums(double degrees) {
    const double angle = degrees / 180 * std::numbers::pi;
    const Vec3 along{-std::cos(angle), 0, -std::sin(angle)};
    const std::vector<Vec3> normals{up, {std::sin(angle), 0, -std::cos(angle)}};
    Random random(1);
    for (int i = 0; i < 200000; ++i) {
      Vec3 x = (8 * random.uniform()) * (i % 2 == 0 ? Vec3{-1, 0, 0} : along);
      x.x += random.gaussian();
      x.z += random.gaussian();
      const double share = shares(x, normals, 1)[0];
      soft += share * x.z;
      soft_square += share * share * x.z * x.z;
      if (share <= 0.5) continue;
      hard += x.z;
      hard_square += x.z * x.z;
    }
  }
};

// Sorting the points of an edge to the nearer face keeps the noise that points outward and loses
// that which points inward. Shares do not.
TEST(SheetShares, MakeHeightsThatAreRightInTheMean) {
  for (const double degrees : {60.0, 90.0, 130.0}) {
    const EdgeSums sums(degrees);
    EXPECT_LT(std::abs(sums.soft), 2.5 * std::sqrt(sums.soft_square)) << degrees;  // standard error
    EXPECT_GT(sums.hard, 8 * std::sqrt(sums.hard_square)) << degrees;
  }
}

// The same at a corner of three faces.
TEST(SheetShares, MakeHeightsThatAreRightAtACorner) {
  Random random(2);
  const std::vector<Vec3> normals{ahead, left, up};
  double soft = 0, square = 0;
  for (int i = 0; i < 150000; ++i) {
    std::array<double, 3> at{-5 * random.uniform(), -5 * random.uniform(), -5 * random.uniform()};
    at.at(static_cast<std::size_t>(i) % 3) = 0;
    for (double& v : at) v += random.gaussian();
    const double term = shares({at[0], at[1], at[2]}, normals, 1)[2] * at[2];
    soft += term;
    square += term * term;
  }
  EXPECT_LT(std::abs(soft), 2.5 * std::sqrt(square));
}

// A sheet that goes on past the other loses nothing there.
TEST(SheetShares, AreOfDistancesAloneWhereNothingEnds) {
  const std::vector<double> found = shares({0.5, 0, 1}, {up, ahead}, 1, 0);
  EXPECT_NEAR(found[0] / found[1], std::exp((0.25 - 1) / 2), 1e-4);
}

TEST(SheetShares, StandPointsBeyondEverything) {
  for (const double far : {10.0, 1e3, 1e6, 1e100}) {
    for (const double noise : {1.0, 1e-3}) {
      const std::vector<double> found = shares({far, 0, 2 * far}, {up, ahead}, noise);
      EXPECT_NEAR(sum(found), 1, 1e-15) << far;
      for (const double share : found) {
        EXPECT_GE(share, 0);
        EXPECT_LE(share, 1);
      }
    }
  }
}

TEST(SheetShares, AreTheSameInAnyUnit) {
  const Vec3 x{0.2, 0.4, -0.3};
  const std::vector<double> plain = shares(x, {up, ahead, left}, 1);
  for (const double unit : {1e-6, 1e6, 1e-150, 1e150}) {
    const std::vector<double> found = shares(unit * x, {up, ahead, left}, unit);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[k], plain[k], 1e-13) << unit;
  }
}

}  // namespace
}  // namespace deburr

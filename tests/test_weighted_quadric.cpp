// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "random.hpp"
#include "weighted_quadric.hpp"

namespace deburr {
namespace {

struct Sample {
  double x, y, height, weight, points;
};

/// Samples within `radius` on a quadric, with weights and numbers of points of all kinds.
std::vector<Sample> samples_on(const HeightQuadric& surface, double radius, std::size_t count,
                               unsigned seed) {
  Random random(seed);
  std::vector<Sample> samples;
  while (samples.size() < count) {
    const double x = radius * (2 * random.uniform() - 1);
    const double y = radius * (2 * random.uniform() - 1);
    if (x * x + y * y > radius * radius) continue;
    const double points = 1 + std::floor(4 * random.uniform());
    const double weight = (0.1 + random.uniform()) * points;
    samples.push_back({x, y, surface.height(x, y), weight, points});
  }
  return samples;
}

/// The sums by their definition, one product after the other.
void add(WeightedQuadric& quadric, const Sample& s) {
  auto& sums = quadric.sums();
  const double x = s.x / quadric.scale();
  const double y = s.y / quadric.scale();
  const double share = s.weight / s.points;
  std::size_t k = 0;
  for (int degree = 0; degree <= 4; ++degree) {
    for (int of_y = 0; of_y <= degree; ++of_y, ++k) {
      const double term = std::pow(x, degree - of_y) * std::pow(y, of_y);
      sums.normal.at(k) += s.weight * term;
      if (degree <= 2) sums.right.at(k) += s.weight * s.height * term;
    }
  }
  sums.heights += s.weight * s.height * s.height;
  sums.spread += s.weight * share;
  sums.shares += share;
  sums.share_squares += share * share;
  ++sums.count;
}

struct Fit : WeightedQuadric::Solution {
  double variance = 0;  ///< of the height at the origin, for points of variance 1
};
struct Both {
  Fit plane, quadric;
  double curvature = 0;
};

Both solve(const WeightedQuadric& sums, const std::vector<Sample>& samples) {
  const auto with_variance = [&](const WeightedQuadric::Solution& solution) {
    Fit fit{solution, 0};
    for (const Sample& s : samples) {
      fit.variance += std::pow(s.weight * fit.pull.height(s.x, s.y), 2) / s.points;
    }
    return fit;
  };
  const WeightedQuadric::Solver solver = sums.solve();
  return {with_variance(solver.plane()), with_variance(solver.quadric()), solver.curvature()};
}

Both solve(const std::vector<Sample>& samples, double scale) {
  WeightedQuadric sums(scale);
  for (const Sample& s : samples) add(sums, s);
  return solve(sums, samples);
}

/// Gaussian heights: variance sigma^2 over the number of points.
std::vector<Sample> with_heights(std::vector<Sample> samples, double sigma, Random& random) {
  for (Sample& s : samples) s.height += sigma * random.gaussian() / std::sqrt(s.points);
  return samples;
}

TEST(WeightedQuadric, FindsAnExactQuadric) {
  for (const double radius : {1e-3, 1.0, 1e4}) {
    const double bend = 1 / radius;
    const HeightQuadric truth{{0.3 * radius, -0.2, 0.7, 0.5 * bend, -0.4 * bend, 0.8 * bend}};
    const auto both = solve(samples_on(truth, radius, 60, 1), radius);
    EXPECT_NEAR(both.quadric.surface.c[0], truth.c[0], 1e-5 * radius);
    for (const std::size_t k : {1U, 2U}) EXPECT_NEAR(both.quadric.surface.c[k], truth.c[k], 1e-5);
    for (const std::size_t k : {3U, 4U, 5U}) {
      EXPECT_NEAR(both.quadric.surface.c[k], truth.c[k], 3e-5 * bend);
    }
    EXPECT_LT(both.quadric.residual, 1e-5 * radius * radius);
    EXPECT_GT(both.plane.residual, 1e-2 * radius * radius);
  }
}

TEST(WeightedQuadric, FindsAnExactPlane) {
  const HeightQuadric truth{{0.3, -0.2, 0.7, 0, 0, 0}};
  const auto both = solve(samples_on(truth, 1, 30, 2), 1);
  for (const std::size_t k : {0U, 1U, 2U}) {
    EXPECT_NEAR(both.plane.surface.c[k], truth.c[k], 1e-8);
    EXPECT_NEAR(both.quadric.surface.c[k], truth.c[k], 1e-8);
  }
  for (const std::size_t k : {3U, 4U, 5U}) EXPECT_EQ(both.plane.surface.c[k], 0);
  EXPECT_LT(both.plane.residual, 1e-8);
}

/// What textbooks say of weighted least squares with independent errors.
void expect_as_of_the_textbook(const std::vector<Sample>& samples, Eigen::Index parameters,
                               const Fit& found) {
  const auto n = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd terms(n, parameters);
  Eigen::VectorXd heights(n);
  Eigen::VectorXd weights(n);
  Eigen::VectorXd variances(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Sample& s = samples[static_cast<std::size_t>(k)];
    const Eigen::VectorXd all =
        (Eigen::VectorXd(6) << 1, s.x, s.y, s.x * s.x, s.x * s.y, s.y * s.y).finished();
    terms.row(k) = all.head(parameters);
    heights(k) = s.height;
    weights(k) = s.weight;
    variances(k) = 1 / s.points;
  }
  const Eigen::MatrixXd pull = (terms.transpose() * weights.asDiagonal() * terms).inverse() *
                               terms.transpose() * weights.asDiagonal();
  const Eigen::VectorXd c = pull * heights;
  for (Eigen::Index k = 0; k < parameters; ++k) {
    EXPECT_NEAR(found.surface.c.at(static_cast<std::size_t>(k)), c(k), 1e-4);
  }
  const double variance = pull.row(0).cwiseAbs2().dot(variances);
  EXPECT_NEAR(found.variance, variance, 1e-4 * variance);
}

TEST(WeightedQuadric, SolvesTheNormalEquations) {
  Random random(3);
  const std::vector<Sample> samples =
      with_heights(samples_on({{0.1, 0.2, 0, 0.6, 0, -0.3}}, 1, 40, 4), 0.2, random);
  const auto both = solve(samples, 1);
  expect_as_of_the_textbook(samples, 3, both.plane);
  expect_as_of_the_textbook(samples, 6, both.quadric);
}

TEST(WeightedQuadric, KnowsHowSureItIs) {
  const double sigma = 0.3;
  const HeightQuadric truth{{0.1, 0.2, 0, 0, 0, 0}};
  const std::vector<Sample> exact = samples_on(truth, 1, 40, 5);
  Random random(6);
  constexpr int runs = 4000;
  double plane = 0, quadric = 0, plane_residual = 0, quadric_residual = 0;
  Both both;
  for (int run = 0; run < runs; ++run) {
    both = solve(with_heights(exact, sigma, random), 1);
    plane += std::pow(both.plane.surface.c[0] - truth.c[0], 2) / runs;
    quadric += std::pow(both.quadric.surface.c[0] - truth.c[0], 2) / runs;
    plane_residual += both.plane.residual / runs;
    quadric_residual += both.quadric.residual / runs;
  }
  const double variance = sigma * sigma;
  EXPECT_NEAR(plane / variance, both.plane.variance, 0.1 * both.plane.variance);
  EXPECT_NEAR(quadric / variance, both.quadric.variance, 0.1 * both.quadric.variance);
  EXPECT_GT(both.quadric.variance, 1.5 * both.plane.variance);
  EXPECT_NEAR(plane_residual / variance, 1, 0.05);
  EXPECT_NEAR(quadric_residual / variance, 1, 0.05);
}

TEST(WeightedQuadric, TakesOffNoiseWhatItIsAllowed) {
  const double sigma = 0.3;
  std::vector<Sample> exact = samples_on({{0.1, 0.2, 0, 0, 0, 0}}, 1, 40, 5);
  Random random(6);
  constexpr int runs = 4000;
  double equal = 0, falling = 0;
  for (Sample& s : exact) s.weight = s.points;
  for (int run = 0; run < runs; ++run) {
    equal += solve(with_heights(exact, sigma, random), 1).curvature / runs / (sigma * sigma);
  }
  for (Sample& s : exact) s.weight = (1 - 0.9 * (s.x * s.x + s.y * s.y)) * s.points;
  for (int run = 0; run < runs; ++run) {
    falling += solve(with_heights(exact, sigma, random), 1).curvature / runs / (sigma * sigma);
  }
  EXPECT_NEAR(equal, 1, 0.05);
  // Less where those that would tell a curvature weigh least.
  EXPECT_NEAR(falling, 0.8, 0.2);
}

TEST(WeightedQuadric, TellsCurvatureFromNoise) {
  Random random(7);
  const auto both = solve(with_heights(samples_on({{0, 0, 0, 1, 0, 1}}, 1, 60, 8), 0.1, random), 1);
  EXPECT_GT(both.curvature, 20 * 0.1 * 0.1);
}

TEST(WeightedQuadric, TakesANodeForAsManyPointsAtItsMean) {
  std::vector<Sample> points;
  Random random(9);
  const std::vector<Sample> nodes =
      with_heights(samples_on({{0, 0, 0, 1, 0, 1}}, 1, 30, 10), 0.1, random);
  for (const Sample& s : nodes) {
    for (int k = 0; k < static_cast<int>(s.points); ++k) {
      points.push_back({s.x, s.y, s.height, s.weight / s.points, 1});
    }
  }
  const Both of_nodes = solve(nodes, 1);
  const Both of_points = solve(points, 1);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(of_nodes.plane.surface.c[k], of_points.plane.surface.c[k], 1e-12);
    EXPECT_NEAR(of_nodes.quadric.surface.c[k], of_points.quadric.surface.c[k], 1e-12);
  }
  EXPECT_NEAR(of_nodes.plane.variance, of_points.plane.variance, 1e-12);
  EXPECT_NEAR(of_nodes.quadric.variance, of_points.quadric.variance, 1e-12);
}

TEST(WeightedQuadric, IsAPlaneWhereSamplesAreFew) {
  const auto both = solve(samples_on({{0, 0, 0, 1, 0, 1}}, 1, 8, 11), 1);
  EXPECT_EQ(both.quadric.surface.c, both.plane.surface.c);
  EXPECT_EQ(both.quadric.variance, both.plane.variance);
}

TEST(WeightedQuadric, MakesNoSlopeOutOfALine) {
  std::vector<Sample> samples;
  for (int k = -10; k <= 10; ++k) samples.push_back({0.1 * k, 0, 0.02 * k, 1, 1});
  const auto both = solve(samples, 1);
  for (const auto* s : {&both.plane, &both.quadric}) {
    EXPECT_NEAR(s->surface.c[1], 0.2, 1e-5);
    EXPECT_NEAR(s->surface.c[2], 0, 1e-12);
    EXPECT_NEAR(s->surface.c[5], 0, 1e-12);
    EXPECT_TRUE(std::isfinite(s->variance));
  }
}

TEST(WeightedQuadric, MakesNoCurvatureOutOfSamplesAtOneDistance) {
  // Nearly: through these goes a cap with its top at -4.75, over less than a thousandth of height.
  std::vector<Sample> samples;
  for (int k = 0; k < 24; ++k) {
    const double angle = 0.26 * k;
    const double wave = std::sin(5 * angle);
    const double radius = 1 + 1e-4 * wave;
    samples.push_back(
        {radius * std::cos(angle), radius * std::sin(angle), 0.25 + 1e-3 * wave, 1, 1});
  }
  const auto both = solve(samples, 1);
  EXPECT_NEAR(both.quadric.surface.c[0], 0.25, 0.5);
  EXPECT_NEAR(both.quadric.surface.height(1, 0), 0.25, 1e-3);
}

TEST(WeightedQuadric, IsLevelWhereAllSamplesAreAtOnePlace) {
  for (const double weight : {1.0, 1e-100}) {
    const auto both = solve(std::vector<Sample>(12, {0, 0, 0.25, weight, 1}), 1);
    for (const auto* s : {&both.plane, &both.quadric}) {
      EXPECT_NEAR(s->surface.c[0], 0.25, 1e-3);
      for (std::size_t k = 1; k < 6; ++k) EXPECT_EQ(s->surface.c.at(k), 0);
    }
    EXPECT_EQ(both.curvature, 0);
  }
}

// A plane stands for the quadric then, and nothing is known of the curvature, in whatever unit.
TEST(WeightedQuadric, TellsNoCurvatureOfTooFewSamples) {
  WeightedQuadric sums(1);
  for (int k = 0; k < 8; ++k) {
    add(sums, {static_cast<double>(k % 3), static_cast<double>(k / 3), 1e-6 * k, 1, 1});
  }
  EXPECT_EQ(sums.solve().curvature(), 0);
  EXPECT_EQ(sums.solve().quadric().surface.c, sums.solve().plane().surface.c);
}

}  // namespace
}  // namespace deburr

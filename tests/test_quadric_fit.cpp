// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <Eigen/Dense>

#include "quadric_fit.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

constexpr HeightQuadric truth{{0.3, -0.2, 0.5, 1.5, -0.7, 0.9}};

std::vector<Vec3> on_quadric(std::vector<Vec3> points) {
  for (Vec3& p : points) p.z = truth.height(p.x, p.y);
  return points;
}

TEST(FitQuadric, FindsAnExactQuadric) {
  const QuadricFit fit = fit_quadric(on_quadric(random_points(20, 1)), 1);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(fit.surface.c[i], truth.c[i], 1e-11);
  EXPECT_EQ(fit.count, 20);
  EXPECT_EQ(fit.rank, 6);
  EXPECT_EQ(fit.freedom(), 14);
  EXPECT_LT(fit.variance(), 1e-24);
}

TEST(FitQuadric, IsTheSolutionOfLeastSquares) {
  const std::vector<Vec3> points = random_points(40, 2);
  Eigen::MatrixXd a(40, 6);
  Eigen::VectorXd z(40);
  for (Eigen::Index i = 0; i < 40; ++i) {
    const Vec3& p = points[static_cast<std::size_t>(i)];
    a.row(i) << 1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y;
    z(i) = p.z;
  }
  const Eigen::VectorXd c = a.colPivHouseholderQr().solve(z);
  const QuadricFit fit = fit_quadric(points, 0.5);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(fit.surface.c[i], c(static_cast<Eigen::Index>(i)), 1e-10);
  }
  EXPECT_NEAR(fit.squares, (z - a * c).squaredNorm(), 1e-12);
}

TEST(FitQuadric, DoesNotDependOnTheScale) {
  const std::vector<Vec3> points = random_points(40, 3);
  const QuadricFit fit = fit_quadric(points, 1);
  const QuadricFit other =
      fit_quadric(mapped(points, [](const Vec3& p) { return 1e-9 * p; }), 1e-9);
  EXPECT_NEAR(other.squares / fit.squares, 1e-18, 1e-28);
  EXPECT_EQ(other.rank, 6);
}

TEST(FitQuadric, LeavesOutWhatThePointsDoNotTell) {
  const std::vector<Vec3> line = mapped(random_points(12, 4), [](const Vec3& p) {
    return Vec3{p.x, 2 * p.x, 3 * p.x};
  });
  const QuadricFit fit = fit_quadric(line, 1);
  EXPECT_EQ(fit.rank, 3);  // 1, x, x^2
  EXPECT_LT(fit.squares, 1e-24);
  EXPECT_EQ(fit_quadric(std::vector<Vec3>(7, {1, 2, 3}), 1).rank, 1);
  EXPECT_EQ(fit_quadric({}, 1).rank, 0);
  EXPECT_EQ(fit_quadric({}, 1).variance(), 0);
}

TEST(FitQuadric, GivesTheVarianceWithoutBias) {
  double sum = 0;
  constexpr int fits = 2000;
  for (unsigned i = 0; i < fits; ++i) {
    std::vector<Vec3> noisy = on_quadric(random_points(12, i));
    Random random(i + 10000);
    for (Vec3& p : noisy) p.z += 0.1 * random.gaussian();
    sum += fit_quadric(noisy, 1).variance();
  }
  EXPECT_NEAR(sum / fits, 0.01, 0.0005);
}

TEST(HeightQuadric, HasTheSlopesOfItsHeight) {
  constexpr double h = 1e-6;
  EXPECT_NEAR(truth.slope_x(0.4, -0.3),
              (truth.height(0.4 + h, -0.3) - truth.height(0.4 - h, -0.3)) / (2 * h), 1e-8);
  EXPECT_NEAR(truth.slope_y(0.4, -0.3),
              (truth.height(0.4, -0.3 + h) - truth.height(0.4, -0.3 - h)) / (2 * h), 1e-8);
}

TEST(Frame, IsRightHandedAndOrthonormal) {
  for (const Vec3& w : random_directions(20, 5)) {
    const Frame frame = frame_along({1, 2, 3}, w);
    EXPECT_NEAR(norm(cross(frame.u, frame.v) - w), 0, 1e-14);
    EXPECT_NEAR(norm(frame.u), 1, 1e-14);
    EXPECT_NEAR(frame.local(frame.origin + 2 * w).z, 2, 1e-14);
    EXPECT_NEAR(frame.local(frame.origin + 2 * w).x, 0, 1e-14);
  }
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <vector>

#include "random.hpp"
#include "support/shapes.hpp"
#include "sym3.hpp"

namespace deburr {
namespace {

Sym3 sum_of(const std::vector<Vec3>& vectors) {
  Sym3 m;
  for (const Vec3& v : vectors) m.add_outer(1, v);
  return m;
}

/// R diag(a, b, c) R^T with a random rotation R.
Sym3 with_spectrum(double a, double b, double c, unsigned seed) {
  const Rotation r = random_rotation(seed);
  Sym3 m;
  m.add_outer(a, r.rows[0]);
  m.add_outer(b, r.rows[1]);
  m.add_outer(c, r.rows[2]);
  return m;
}

/// Residuals are measured against the largest entry.
void expect_decomposed(const Sym3& m) {
  const Spectrum s = spectrum(m);
  const double size = m.matrix().cwiseAbs().maxCoeff();
  EXPECT_GE(s.values[0], s.values[1]);
  EXPECT_GE(s.values[1], s.values[2]);
  Eigen::Matrix3d v;
  for (int q = 0; q < 3; ++q) v.col(q) = to_eigen(s.vectors.at(static_cast<std::size_t>(q)));
  EXPECT_LE((v.transpose() * v - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 4e-15);
  const Eigen::Vector3d l(s.values[0], s.values[1], s.values[2]);
  const Eigen::Matrix3d residual = m.matrix() * v - v * l.asDiagonal();
  EXPECT_LE(residual.cwiseAbs().maxCoeff(), 4e-15 * size);
  if (!(size > 0)) return;
  const Eigen::Vector3d expected =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m.matrix() / size).eigenvalues().reverse();
  EXPECT_LE((l / size - expected).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(Spectrum, EqualsThatOfEigenOnRandomMatrices) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    expect_decomposed(sum_of(random_directions(1 + seed % 9, seed)));
  }
}

TEST(Spectrum, HoldsWhereEigenvaluesAreClose) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    for (const double gap : {0.0, 1e-16, 1e-12, 1e-8, 1e-4}) {
      expect_decomposed(with_spectrum(1, 1 - gap, 1 - 2 * gap, seed));
      expect_decomposed(with_spectrum(1, gap, 0, seed));
      expect_decomposed(with_spectrum(1, 1 - gap, gap, seed));
    }
  }
}

TEST(Spectrum, SortsADiagonalMatrix) {
  Sym3 m;
  m.xx = 1;
  m.yy = 3;
  m.zz = 2;
  const Spectrum s = spectrum(m);
  EXPECT_THAT(s.values, testing::ElementsAre(3, 2, 1));
  EXPECT_EQ(s.vectors[0], (Vec3{0, 1, 0}));
  EXPECT_EQ(s.vectors[1], (Vec3{0, 0, 1}));
  EXPECT_EQ(s.vectors[2], (Vec3{1, 0, 0}));
}

TEST(Spectrum, FindsTheDirectionOfOneVector) {
  const Vec3 v = random_directions(1, 4)[0];
  const Spectrum s = spectrum(sum_of({v}));
  EXPECT_NEAR(s.values[0], 1, 4e-16);
  EXPECT_NEAR(std::abs(dot(s.vectors[0], v)), 1, 4e-16);
  EXPECT_NEAR(s.values[1], 0, 4e-16);
}

TEST(Spectrum, OfZeroIsZeroAlongTheAxes) {
  expect_decomposed({});
  EXPECT_THAT(spectrum({}).values, testing::ElementsAre(0, 0, 0));
}

TEST(Spectrum, HoldsForTinyAndHugeMatrices) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    for (const double size : {1e-300, 1e-150, 1e150, 1e300}) {
      Sym3 m = sum_of(random_directions(4, seed));
      m.scale(size);
      expect_decomposed(m);
    }
  }
}

TEST(Spectrum, StopsAtTheTolerance) {
  Sym3 m;
  m.xx = 3;
  m.yy = 2;
  m.zz = 1;
  m.xy = m.xz = m.yz = 0.125;
  EXPECT_EQ(spectrum(m, 0.375).vectors[0], (Vec3{1, 0, 0}));
  EXPECT_NE(spectrum(m, 0.374).vectors[0], (Vec3{1, 0, 0}));
}

}  // namespace
}  // namespace deburr

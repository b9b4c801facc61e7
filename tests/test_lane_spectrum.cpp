// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "lane_spectrum.hpp"
#include "support/shapes.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Whether all bits are the same; but any NaN is as good as any other.
bool same_bits(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof a) == 0;
}
bool same_bits(const Vec3& a, const Vec3& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

/// Decomposes eight matrices at once and one after the other.
void expect_same(const std::array<Sym3, lane_count>& matrices, double tolerance) {
  LanesSym3 all;
  for (std::size_t l = 0; l < lane_count; ++l) set_lane(all, l, matrices[l]);
  const LanesSpectrum s = spectrum(all, tolerance);
  for (std::size_t l = 0; l < lane_count; ++l) {
    const Spectrum expected = spectrum(matrices[l], tolerance);
    for (std::size_t q = 0; q < 3; ++q) {
      EXPECT_TRUE(same_bits(s.values[q][l], expected.values[q])) << l << ' ' << q;
      EXPECT_TRUE(same_bits(lane(s.vectors[q], l), expected.vectors[q])) << l << ' ' << q;
    }
  }
}

Sym3 random_matrix(std::size_t vectors, double size, unsigned seed) {
  Sym3 m;
  for (const Vec3& v : random_directions(vectors, seed)) m.add_outer(size, v);
  return m;
}

TEST(LanesSpectrum, HasTheBitsOfSpectrum) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::array<Sym3, lane_count> matrices;
    for (std::size_t l = 0; l < lane_count; ++l) {
      // Of different rank and size, so that lanes end after different numbers of sweeps.
      matrices[l] = random_matrix(1 + l % 5, std::pow(10.0, static_cast<double>(l) - 4),
                                  8 * seed + static_cast<unsigned>(l));
    }
    for (const double tolerance : {0.0, 1e-10, 1e-3}) expect_same(matrices, tolerance);
  }
}

TEST(LanesSpectrum, HasTheBitsOfSpectrumInSpecialCases) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Sym3 diagonal{1, 0, 0, 3, 0, 2};
  const Sym3 equal{2, 0, 0, 2, 0, 2};
  const Sym3 nearly{1, 1e-17, -1e-17, 1, 1e-9, 1};
  expect_same({Sym3{}, diagonal, equal, nearly, Sym3{nan, nan, nan, nan, nan, nan},
               Sym3{1, nan, 0, 1, 0, 1}, random_matrix(3, 1e200, 1), random_matrix(3, 1e-200, 2)},
              0);
}

TEST(LanesUnit, HasTheBitsOfUnit) {
  std::vector<Vec3> vectors = random_points(6, 3);
  vectors.push_back({});
  vectors.push_back({0, 1e-11, 0});
  Lanes3 all;
  for (std::size_t l = 0; l < lane_count; ++l) set_lane(all, l, vectors[l]);
  const Lanes3 units = unit(all);
  for (std::size_t l = 0; l < lane_count; ++l) {
    EXPECT_TRUE(same_bits(lane(units, l), unit(vectors[l]))) << l;
  }
}

}  // namespace
}  // namespace deburr

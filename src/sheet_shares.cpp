// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_shares.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <array>
#include <cmath>

namespace deburr {
namespace {

/// exp(-x) for x >= 0 to 1e-4 of it where it matters; of products and a quotient alone, whose bits
/// no library changes.
double falling(double x) {
  double y = 1 / (1 + x / 256 + x * x / 131072);
  for (int i = 0; i < 8; ++i) y *= y;
  return y;
}

/// The share of a normal distribution below t, to 2e-4.
/// Source: Bowling, Khasawneh, Kaewkuekool, Cho, A logistic approximation to the cumulative normal
/// distribution, JIEM 2009.
double normal_share(double t) {
  const double u = t * (1.5976 + 0.07056 * t * t);
  return u >= 0 ? 1 / (1 + falling(u)) : falling(-u) / (1 + falling(-u));
}

}  // namespace

void set_shares(const Vec3& x, std::span<CutSheet> sheets, const SideOf side[3][3], double noise) {
  std::array<double, 3> square{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    square[k] = squared_norm(x - sheets[k].foot) / (noise * noise);
    least = std::min(least, square[k]);
  }
  double total = 0;
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    double share = falling((square[k] - least) / 2);
    for (std::size_t j = 0; j < sheets.size(); ++j) {
      if (j == k || side[j][k] == 0) continue;
      const double cosine = dot(sheets[j].normal, sheets[k].normal);
      const double sine = std::sqrt(std::max(1e-6, 1 - cosine * cosine));
      const double inside = side[j][k] * dot(sheets[k].foot - sheets[j].foot, sheets[j].normal) / sine;
      share *= normal_share(inside / noise);
    }
    sheets[k].share = share;
    total += share;
  }
  static const double C = getenv("CL") ? atof(getenv("CL")) : 0;
  std::array<double, 3> f{1, 1, 1};
  if (C > 0) {
    for (std::size_t k = 0; k < sheets.size(); ++k) {
      for (std::size_t j = 0; j < sheets.size(); ++j) {
        if (j == k) continue;
        f[k] = std::min(f[k], std::clamp(std::abs(dot(sheets[k].foot - sheets[j].foot, sheets[j].normal)) / (C * noise), 0.05, 1.0));
      }
    }
  }
  for (std::size_t k = 0; k < sheets.size(); ++k) sheets[k].share = f[k] * (total > 0 ? sheets[k].share / total : 1.0 / sheets.size());
}

}  // namespace deburr

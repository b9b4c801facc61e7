// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

void set_shares(const Vec3& x, std::span<CutSheet> sheets, const Sides& side, double noise) {
  std::array<double, most_sheets> square{};
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
      const double inside =
          side[j][k] * dot(sheets[k].foot - sheets[j].foot, sheets[j].normal) / sine;
      share *= normal_share(inside / noise);
    }
    sheets[k].share = share;
    total += share;
  }
  // So far from all of them that no number is left.
  const double none = 1 / static_cast<double>(sheets.size());
  for (CutSheet& s : sheets) s.share = total > 0 ? s.share / total : none;
}

}  // namespace deburr

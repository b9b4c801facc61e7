// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outlier_patch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sym3.hpp"

namespace deburr {
namespace {

constexpr std::size_t terms = 6;
constexpr int rounds = 3;

using Row = std::array<double, terms>;

/// Weighted sums of the monomials of a place in each other and in the height. The 36 products of
/// two monomials are only 15 different ones.
/// @return the sum of the weights
double normal_equations(std::span<const Vec3> points, std::span<const double> weight,
                        std::array<Row, terms>& a, Row& b) {
  std::array<double, 15> m{};
  b = {};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [u, v, h] = points[i];
    const double w = weight[i];
    const double wu = w * u;
    const double wv = w * v;
    const double uu = u * u;
    const double uv = u * v;
    const double vv = v * v;
    const double wuu = w * uu;
    const double wuv = w * uv;
    const double wvv = w * vv;
    m[0] += w;
    m[1] += wu;
    m[2] += wv;
    m[3] += wuu;
    m[4] += wuv;
    m[5] += wvv;
    m[6] += wu * uu;
    m[7] += wu * uv;
    m[8] += wu * vv;
    m[9] += wv * vv;
    m[10] += wuu * uu;
    m[11] += wuu * uv;
    m[12] += wuu * vv;
    m[13] += wuv * vv;
    m[14] += wvv * vv;
    b[0] += w * h;
    b[1] += wu * h;
    b[2] += wv * h;
    b[3] += wuu * h;
    b[4] += wuv * h;
    b[5] += wvv * h;
  }
  a = {{{m[0]},
        {m[1], m[3]},
        {m[2], m[4], m[5]},
        {m[3], m[6], m[7], m[10]},
        {m[4], m[7], m[8], m[11], m[12]},
        {m[5], m[8], m[9], m[12], m[13], m[14]}}};
  return m[0];
}

/// Solves the symmetric positive definite system a x = b, whose lower half is given, by Cholesky.
void solve(std::array<Row, terms>& a, Row& b) {
  for (std::size_t j = 0; j < terms; ++j) {
    for (std::size_t k = 0; k < j; ++k) {
      for (std::size_t i = j; i < terms; ++i) a[i][j] -= a[i][k] * a[j][k];
    }
    const double root = std::sqrt(a[j][j]);
    for (std::size_t i = j; i < terms; ++i) a[i][j] /= root;
  }
  for (std::size_t i = 0; i < terms; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (std::size_t i = terms; i-- > 0;) {
    for (std::size_t k = i + 1; k < terms; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
}

Row monomials(double u, double v) { return {1, u, v, u * u, u * v, v * v}; }

double value(const Row& height, const Row& at) {
  double sum = 0;
  for (std::size_t k = 0; k < terms; ++k) sum += height[k] * at[k];
  return sum;
}

}  // namespace

Patch fit_patch(std::span<const Vec3> points, const Vec3& around) {
  const std::size_t n = points.size();
  thread_local std::vector<Vec3> local;
  thread_local std::vector<double> weight;
  thread_local std::vector<double> residual;
  thread_local std::vector<double> sorted;
  local.resize(n);
  residual.resize(n);
  weight.assign(n, 1);

  Patch patch;
  Vec3 sum;
  double farthest = 0;
  for (const Vec3& p : points) {
    sum += p - around;
    farthest = std::max(farthest, squared_norm(p - around));
  }
  const Vec3 mean = (1 / static_cast<double>(n)) * sum;
  patch.center = around + mean;
  patch.radius = std::sqrt(farthest);
  const double unit = 1 / patch.radius;
  Sym3 covariance;
  for (std::size_t i = 0; i < n; ++i) {
    local[i] = unit * (points[i] - around - mean);
    covariance.add_outer(1, local[i]);
  }
  const Spectrum s = spectrum(covariance);
  patch.u = s.vectors[0];
  patch.v = s.vectors[1];
  patch.normal = s.vectors[2];
  patch.flatness = s.values[1] > 0 ? std::sqrt(std::max(0.0, s.values[2]) / s.values[1]) : 0;
  for (Vec3& p : local) p = {dot(p, patch.u), dot(p, patch.v), dot(p, patch.normal)};

  for (int round = 0; round < rounds; ++round) {
    std::array<Row, terms> a;
    Row b;
    const double total = normal_equations(local, weight, a, b);
    // Points along a line leave the curvature across it open: it is then 0.
    constexpr Row ridge{1e-9, 1e-6, 1e-6, 1e-3, 1e-3, 1e-3};
    for (std::size_t p = 0; p < terms; ++p) a[p][p] += ridge[p] * total;
    solve(a, b);
    patch.height = b;
    if (round + 1 == rounds) break;
    for (std::size_t i = 0; i < n; ++i) {
      residual[i] = std::abs(local[i].z - value(b, monomials(local[i].x, local[i].y)));
    }
    // The 80th percentile, since half of the points may be without noise.
    sorted = residual;
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(4 * n / 5);
    std::nth_element(sorted.begin(), at, sorted.end());
    patch.spread = patch.radius * *at / 1.2816;
    const double reach = std::max(3 / 1.2816 * *at, 1e-6);
    for (std::size_t i = 0; i < n; ++i) {
      const double share = residual[i] / reach;
      const double left = 1 - share * share;
      weight[i] = share < 1 ? left * left : 0;
    }
  }
  return patch;
}

Foot foot_on(const Patch& patch, const Vec3& point) {
  const double unit = 1 / patch.radius;
  const Vec3 offset = unit * (point - patch.center);
  const double u = dot(offset, patch.u);
  const double v = dot(offset, patch.v);
  const Row& h = patch.height;
  const double height = value(h, monomials(u, v));
  const double du = h[1] + 2 * h[3] * u + h[4] * v;
  const double dv = h[2] + 2 * h[5] * v + h[4] * u;
  const double above = dot(offset, patch.normal) - height;
  Foot foot;
  const double slope2 = 1 + du * du + dv * dv;
  // Along the normal of the patch there, not along that of its plane.
  const double step = above / slope2;
  const Vec3 normal = patch.normal + (-du) * patch.u + (-dv) * patch.v;
  foot.at = point + (-patch.radius * step) * normal;
  foot.distance = patch.radius * std::abs(above) / std::sqrt(slope2);
  foot.aside = patch.radius * std::sqrt(u * u + v * v);
  return foot;
}

}  // namespace deburr

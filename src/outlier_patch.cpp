// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "outlier_patch.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "lanes.hpp"
#include "sym3.hpp"

namespace deburr {
namespace {

constexpr std::size_t terms = 6;
constexpr int rounds = 3;

using Row = std::array<double, terms>;

/// Points in the frame of a patch, one coordinate after the other, up to a multiple of the lanes:
/// those beyond the last have no weight.
class Columns {
 public:
  void resize(std::size_t n) {
    const std::size_t padded = (n + lane_count - 1) / lane_count * lane_count;
    for (std::vector<double>* column : {&u, &v, &h, &weight, &residual}) column->assign(padded, 0);
    std::fill_n(weight.begin(), n, 1.0);
  }
  [[nodiscard]] std::size_t padded() const { return weight.size(); }

  std::vector<double> u, v, h, weight, residual;
};

DEBURR_LANES_INLINE Lanes load(const std::vector<double>& column, std::size_t at) {
  Lanes lanes;
  std::memcpy(&lanes, column.data() + at, sizeof lanes);
  return lanes;
}

DEBURR_LANES_INLINE void store(const Lanes& lanes, std::vector<double>& column, std::size_t at) {
  std::memcpy(column.data() + at, &lanes, sizeof lanes);
}

/// Sum of weight times outer product.
DEBURR_MULTIVERSION
Sym3 covariance_of(const Columns& c) {
  LanesSym3 total;
  for (std::size_t k = 0; k < c.padded(); k += lane_count) {
    total.add_outer(load(c.weight, k), {load(c.u, k), load(c.v, k), load(c.h, k)});
  }
  return sum(total);
}

/// Coordinates along three axes instead.
DEBURR_MULTIVERSION
void turn(Columns& c, const Spectrum& axes) {
  const Lanes3 u = all_lanes(axes.vectors[0]);
  const Lanes3 v = all_lanes(axes.vectors[1]);
  const Lanes3 h = all_lanes(axes.vectors[2]);
  for (std::size_t k = 0; k < c.padded(); k += lane_count) {
    const Lanes3 p{load(c.u, k), load(c.v, k), load(c.h, k)};
    store(dot(p, u), c.u, k);
    store(dot(p, v), c.v, k);
    store(dot(p, h), c.h, k);
  }
}

/// Weighted sums of the monomials of a place in each other and in the height. The 36 products of
/// two monomials are only 15 different ones.
/// @return the sum of the weights
DEBURR_MULTIVERSION
double normal_equations(const Columns& c, std::array<Row, terms>& a, Row& b) {
  std::array<Lanes, 15> m{};
  std::array<Lanes, terms> r{};
  for (std::size_t k = 0; k < c.padded(); k += lane_count) {
    const Lanes u = load(c.u, k);
    const Lanes v = load(c.v, k);
    const Lanes h = load(c.h, k);
    const Lanes w = load(c.weight, k);
    const Lanes wu = w * u;
    const Lanes wv = w * v;
    const Lanes uu = u * u;
    const Lanes uv = u * v;
    const Lanes vv = v * v;
    const Lanes wuu = w * uu;
    const Lanes wuv = w * uv;
    const Lanes wvv = w * vv;
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
    r[0] += w * h;
    r[1] += wu * h;
    r[2] += wv * h;
    r[3] += wuu * h;
    r[4] += wuv * h;
    r[5] += wvv * h;
  }
  std::array<double, 15> s{};
  for (std::size_t k = 0; k < s.size(); ++k) s[k] = sum(m[k]);
  for (std::size_t k = 0; k < terms; ++k) b[k] = sum(r[k]);
  a = {{{s[0]},
        {s[1], s[3]},
        {s[2], s[4], s[5]},
        {s[3], s[6], s[7], s[10]},
        {s[4], s[7], s[8], s[11], s[12]},
        {s[5], s[8], s[9], s[12], s[13], s[14]}}};
  return s[0];
}

DEBURR_MULTIVERSION
void set_residuals(Columns& c, const Row& height) {
  for (std::size_t k = 0; k < c.padded(); k += lane_count) {
    const Lanes u = load(c.u, k);
    const Lanes v = load(c.v, k);
    const Lanes r =
        load(c.h, k) - (height[0] + height[1] * u + height[2] * v + height[3] * (u * u) +
                        height[4] * (u * v) + height[5] * (v * v));
    store(r < 0.0 ? -r : r, c.residual, k);
  }
}

/// Weights of the first n by their residuals.
DEBURR_MULTIVERSION
void set_weights(Columns& c, std::size_t n, double reach) {
  for (std::size_t k = 0; k < c.padded(); k += lane_count) {
    const Lanes share = load(c.residual, k) / reach;
    const Lanes left = 1.0 - share * share;
    store(share < 1.0 ? left * left : Lanes{}, c.weight, k);
  }
  for (std::size_t k = n; k < c.padded(); ++k) c.weight[k] = 0;
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

/// Of points all at one place, whose patch is level: the square of what lies within a box of 4 is
/// still a number in this unit.
constexpr double least_radius = 1e-100;

Row monomials(double u, double v) { return {1, u, v, u * u, u * v, v * v}; }

double value(const Row& height, const Row& at) {
  double sum = 0;
  for (std::size_t k = 0; k < terms; ++k) sum += height[k] * at[k];
  return sum;
}

}  // namespace

Patch fit_patch(std::span<const Vec3> points, const Vec3& around) {
  const std::size_t n = points.size();
  thread_local Columns local;
  thread_local std::vector<double> sorted;
  local.resize(n);

  Patch patch;
  Vec3 sum;
  double farthest = 0;
  for (const Vec3& p : points) {
    sum += p - around;
    farthest = std::max(farthest, squared_norm(p - around));
  }
  const Vec3 mean = (1 / static_cast<double>(n)) * sum;
  patch.center = around + mean;
  patch.radius = std::max(std::sqrt(farthest), least_radius);
  const double unit = 1 / patch.radius;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 p = unit * (points[i] - around - mean);
    local.u[i] = p.x;
    local.v[i] = p.y;
    local.h[i] = p.z;
  }
  const Spectrum s = spectrum(covariance_of(local));
  patch.u = s.vectors[0];
  patch.v = s.vectors[1];
  patch.normal = s.vectors[2];
  patch.flatness = s.values[1] > 0 ? std::sqrt(std::max(0.0, s.values[2]) / s.values[1]) : 0;
  turn(local, s);

  for (int round = 0; round < rounds; ++round) {
    std::array<Row, terms> a;
    Row b;
    const double total = normal_equations(local, a, b);
    // Points along a line leave the curvature across it open: it is then 0.
    constexpr Row ridge{1e-9, 1e-6, 1e-6, 1e-3, 1e-3, 1e-3};
    for (std::size_t p = 0; p < terms; ++p) a[p][p] += ridge[p] * total;
    solve(a, b);
    patch.height = b;
    if (round + 1 == rounds) break;
    set_residuals(local, b);
    // The 80th percentile, since half of the points may be without noise.
    sorted.assign(local.residual.begin(), local.residual.begin() + static_cast<std::ptrdiff_t>(n));
    const auto at = sorted.begin() + static_cast<std::ptrdiff_t>(4 * n / 5);
    std::nth_element(sorted.begin(), at, sorted.end());
    patch.spread = patch.radius * *at / 1.2816;
    set_weights(local, n, std::max(3 / 1.2816 * *at, 1e-6));
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

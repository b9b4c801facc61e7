// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "quadric_fit.hpp"

#include <cmath>

namespace deburr {
namespace {

constexpr std::size_t terms = 6;
using Row = std::array<double, terms>;

/// The normal equations of the fit: only the lower triangle of the matrix is used.
struct NormalEquations {
  std::array<Row, terms> matrix{};
  Row right{};
};

/// Solves by Cholesky's decomposition and returns the rank. A column that depends on those before
/// it, to more digits than the sums hold, is left out: its solution is 0.
std::size_t solve(NormalEquations& e, Row& solution) {
  constexpr double dependent = 1e-10;
  std::array<Row, terms>& l = e.matrix;
  std::array<bool, terms> used{};
  std::size_t rank = 0;
  for (std::size_t j = 0; j < terms; ++j) {
    double pivot = l[j][j];
    for (std::size_t k = 0; k < j; ++k) pivot -= l[j][k] * l[j][k];
    used[j] = pivot > dependent * l[j][j];
    const double root = used[j] ? std::sqrt(pivot) : 0;
    rank += used[j] ? 1 : 0;
    l[j][j] = root;
    for (std::size_t i = j + 1; i < terms; ++i) {
      double entry = l[i][j];
      for (std::size_t k = 0; k < j; ++k) entry -= l[i][k] * l[j][k];
      l[i][j] = used[j] ? entry / root : 0;
    }
  }
  Row half{};
  for (std::size_t j = 0; j < terms; ++j) {
    double rest = e.right[j];
    for (std::size_t k = 0; k < j; ++k) rest -= l[j][k] * half[k];
    half[j] = used[j] ? rest / l[j][j] : 0;
  }
  for (std::size_t j = terms; j-- > 0;) {
    double rest = half[j];
    for (std::size_t i = j + 1; i < terms; ++i) rest -= l[i][j] * solution[i];
    solution[j] = used[j] ? rest / l[j][j] : 0;
  }
  return rank;
}

}  // namespace

Frame frame_along(const Vec3& origin, const Vec3& w) {
  // The axis that w is least along cannot be close to it.
  const Vec3 a{std::abs(w.x), std::abs(w.y), std::abs(w.z)};
  const Vec3 axis = a.x <= a.y && a.x <= a.z ? Vec3{1, 0, 0}
                    : a.y <= a.z             ? Vec3{0, 1, 0}
                                             : Vec3{0, 0, 1};
  const Vec3 across = axis - dot(axis, w) * w;
  const Vec3 u = (1 / norm(across)) * across;
  return {origin, u, cross(w, u), w};
}

QuadricFit fit_quadric(std::span<const Vec3> points, double scale) {
  const double inverse = 1 / scale;
  NormalEquations equations;
  for (const Vec3& p : points) {
    const double x = inverse * p.x;
    const double y = inverse * p.y;
    const Row row{1, x, y, x * x, x * y, y * y};
    for (std::size_t i = 0; i < terms; ++i) {
      equations.right[i] += row[i] * p.z;
      for (std::size_t j = 0; j <= i; ++j) equations.matrix[i][j] += row[i] * row[j];
    }
  }
  QuadricFit fit;
  fit.count = points.size();
  Row& c = fit.surface.c;
  fit.rank = solve(equations, c);
  for (std::size_t i = 1; i < terms; ++i) c[i] *= i < 3 ? inverse : inverse * inverse;
  // Summed from the residuals: the difference of sums would lose what is far below the heights.
  for (const Vec3& p : points) {
    const double residual = p.z - fit.surface.height(p.x, p.y);
    fit.squares += residual * residual;
  }
  return fit;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "weighted_quadric.hpp"

#include <algorithm>

namespace deburr {
namespace {

/// Fewer samples do not determine a quadric well.
constexpr std::size_t fewest_for_quadric = 9;

/// Shares of the total weight that are added to the diagonals: samples on a line, or all at one
/// distance, must not make a slope or a curvature out of rounding.
constexpr double plane_ridge = 1e-9;
constexpr double quadric_ridge = 1e-6;

using Row = QuadricCholesky::Row;

constexpr Row at_origin{1, 0, 0, 0, 0, 0};

/// In the unit of the coordinates, that of scaled ones.
HeightQuadric unscaled(const Row& c, double scale) {
  const double per = 1 / scale;
  return {
      {c[0], c[1] * per, c[2] * per, c[3] * (per * per), c[4] * (per * per), c[5] * (per * per)}};
}

}  // namespace

WeightedQuadric::Solver::Solver(const WeightedQuadric& of)
    : of_(of),
      normal_(of.sums_.normal,
              {plane_ridge * of.sums_.normal[0], quadric_ridge * of.sums_.normal[0]}),
      heights_(normal_.forward(of.sums_.right)) {}

WeightedQuadric::Solution WeightedQuadric::Solver::finish(const Row& c, const Row& pull,
                                                          double squares, double parameters) const {
  const Sums& sums = of_.sums_;
  Solution s;
  s.surface = unscaled(c, of_.scale_);
  s.freedom = std::max(1.0, sums.shares * sums.shares / sums.share_squares - parameters);
  s.residual = std::max(0.0, squares) * sums.normal[0] / sums.spread / s.freedom;
  s.pull = unscaled(pull, of_.scale_);
  return s;
}

WeightedQuadric::Solution WeightedQuadric::Solver::plane() const {
  return finish(normal_.plane(heights_), normal_.plane(normal_.forward(at_origin)),
                of_.sums_.heights - heights_.plane_form, 3);
}

WeightedQuadric::Solution WeightedQuadric::Solver::quadric() const {
  if (of_.sums_.count < fewest_for_quadric) return plane();
  return finish(normal_.quadric(heights_), normal_.quadric(normal_.forward(at_origin)),
                of_.sums_.heights - heights_.plane_form - heights_.rest_form, 6);
}

double WeightedQuadric::Solver::curvature() const {
  if (of_.sums_.count < fewest_for_quadric) return 0;
  return heights_.rest_form / (3 * of_.sums_.spread / of_.sums_.normal[0]);
}

}  // namespace deburr

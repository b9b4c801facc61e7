// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "deburr/features.hpp"
#include "deburr/normal_filter.hpp"
#include "deburr/normals.hpp"
#include "deburr/position_update.hpp"
#include "sym3.hpp"

/// The stages once more, for one point at a time: dense matrices and the eigen-solver of Eigen,
/// written from the formulas and not from the library.
namespace deburr::oracle {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Neighbors = std::span<const std::uint32_t>;

/// Ascending eigenvalues.
inline Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(const Matrix3d& m) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(m);
}

/// Covariance of weighted points about their weighted mean, with weights that sum to 1.
inline Matrix3d covariance(const std::vector<Vector3d>& points, std::vector<double> weights) {
  double total = 0;
  for (const double w : weights) total += w;
  Vector3d mean = Vector3d::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) mean += weights[k] / total * points[k];
  Matrix3d c = Matrix3d::Zero();
  for (std::size_t k = 0; k < points.size(); ++k) {
    c += weights[k] / total * (points[k] - mean) * (points[k] - mean).transpose();
  }
  return c;
}

inline Vec3 pca_normal(Points points, Neighbors neighbors) {
  std::vector<Vector3d> around;
  for (const std::uint32_t j : neighbors) around.push_back(to_eigen(points[j]));
  const std::vector<double> equal(around.size(), 1.0);
  return to_vec3(eigen(covariance(around, equal)).eigenvectors().col(0));
}

inline double weight(Points points, Normals normals, std::size_t i, std::size_t j, double a,
                     double b) {
  const double d = norm(points[j] - points[i]) / a;
  const double m = norm(normals[j] - normals[i]) / b;
  return std::exp(-d * d) * std::exp(-m * m);
}

inline Vec3 refitted_normal(Points points, Normals normals, std::size_t i, Neighbors neighbors,
                            const NormalRefitOptions& o) {
  std::vector<Vector3d> around{to_eigen(points[i])};
  std::vector<double> weights{1};
  for (const std::uint32_t j : neighbors) {
    if (dot(normals[i], normals[j]) <= 0) continue;
    around.push_back(to_eigen(points[j]));
    weights.push_back(weight(points, normals, i, j, o.position_scale, o.normal_scale));
  }
  if (around.size() < 3) return normals[i];
  const Vector3d old = to_eigen(normals[i]);
  Vector3d fitted = eigen(covariance(around, weights)).eigenvectors().col(0);
  if (fitted.dot(old) < 0) fitted = -fitted;
  return to_vec3((o.blend * fitted + (1 - o.blend) * old).normalized());
}

inline Vec3 filtered_normal(Normals normals, std::size_t i, Neighbors neighbors,
                            const NormalFilterOptions& o, Voteless voteless) {
  const Vector3d n = to_eigen(normals[i]);
  Matrix3d tensor = Matrix3d::Zero();
  int votes = 0;
  for (const std::uint32_t j : neighbors) {
    const Vector3d m = to_eigen(normals[j]);
    if (n.dot(m) <= o.rho || n.isZero() || m.isZero()) continue;
    tensor += m * m.transpose();
    ++votes;
  }
  if (votes == 0) return voteless == Voteless::Zero ? Vec3{} : normals[i];
  const auto solved = eigen(tensor / votes);
  Vector3d binary(0, 0, 1);  // ascending: the largest is the last
  for (int q = 0; q < 2; ++q) binary[q] = solved.eigenvalues()[q] < o.tau ? 0 : 1;
  const Matrix3d b =
      solved.eigenvectors() * binary.asDiagonal() * solved.eigenvectors().transpose();
  return to_vec3((o.damping * n + b * n).normalized());
}

struct Class {
  Feature label = Feature::Isolated;
  Vec3 direction;
};

inline Class classify(Points points, Normals normals, std::size_t i, Neighbors neighbors,
                      const FeatureOptions& o) {
  std::vector<Vector3d> same{to_eigen(points[i])};
  for (const std::uint32_t j : neighbors) {
    if (dot(normals[i], normals[j]) > o.rho) same.push_back(to_eigen(points[j]));
  }
  const Matrix3d c = covariance(same, std::vector<double>(same.size(), 1.0));
  if (normals[i] == Vec3{} || c.isZero(0)) return {};
  const auto solved = eigen(c);
  const Vector3d l = solved.eigenvalues() / solved.eigenvalues().norm();
  const auto above = (l.array() > o.tau).count();
  if (above == 1) return {Feature::Edge, to_vec3(solved.eigenvectors().col(2))};
  return {above == 2 ? Feature::Surface : Feature::Corner, {}};
}

/// Where the point would go without the bound; quadrics by Quadric::Plain only.
inline Vec3 unbounded(Points points, Normals normals, std::size_t i, Neighbors neighbors,
                      const Class& c, const PositionUpdateOptions& o) {
  const Vector3d x = to_eigen(points[i]);
  const Vector3d n = to_eigen(normals[i]);
  const Vector3d e = to_eigen(c.direction);
  double offsets = 0;
  double total = 0;
  Matrix3d a = e * e.transpose();
  Vector3d b = e * e.dot(x);
  for (const std::uint32_t j : neighbors) {
    const Vector3d d = to_eigen(points[j]) - x;
    const Vector3d nj = to_eigen(normals[j]);
    const double w = weight(points, normals, i, j, o.position_scale, o.normal_scale);
    offsets += w * (o.offset == Offset::Projected ? n : Vector3d((n + nj) / 2)).dot(d);
    total += w;
    const Vector3d m = nj - e.dot(nj) * e;
    a += m * m.transpose();
    b += m * m.dot(x + d - e.dot(d) * e);
  }
  if (c.label == Feature::Surface) return to_vec3(x + o.step * offsets / total * n);
  return to_vec3(x + o.feature_step * (a.inverse() * b - x));
}

}  // namespace deburr::oracle

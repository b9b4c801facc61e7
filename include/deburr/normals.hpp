// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/execution.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Normals by principal component analysis: the unit eigenvector of the smallest eigenvalue of the
/// covariance of a point's neighbours about their mean; the point itself does not take part. The
/// sign is arbitrary (see orient_normals).
///
/// A point with fewer than 2 neighbours, or whose neighbours all coincide, has no plane and gets
/// the zero vector. Collinear neighbours give one of the directions across the line.
///
/// Source: Yadav et al. 2018, initial normals.
/// @throws std::invalid_argument  if points and neighborhoods differ in size
[[nodiscard]] std::vector<Vec3> estimate_normals(Points points, const Neighborhoods& neighborhoods,
                                                 const Execution& execution = {});

/// How much a neighbour counts when a normal is fitted anew.
struct NormalRefitOptions {
  double position_scale = 0;  ///< Gaussian scale of the distance, in input units, > 0
  double normal_scale = 0.3;  ///< Gaussian scale of |n_i - n_j|, without unit, > 0
  double blend = 0.5;         ///< share of the new normal in the mix with the old one, in [0, 1]
};

/// Normals fitted again around normals that are already nearly right, so that the fit stops at
/// edges: the covariance runs over the point itself and its neighbours j with n_i . n_j > 0,
/// weighted by exp(-|x_j-x_i|^2/position_scale^2) exp(-|n_j-n_i|^2/normal_scale^2); the result is
/// turned to the side of the old normal and blended with it.
///
/// A point without a normal, or with fewer than 3 points in the fit, keeps what it has.
/// @throws std::invalid_argument  if sizes differ or an option is out of its range
[[nodiscard]] std::vector<Vec3> refit_normals(Points points, Normals normals,
                                              const Neighborhoods& neighborhoods,
                                              const NormalRefitOptions& options,
                                              const Execution& execution = {});

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/execution.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Parameters of the normal voting tensor. All are without unit.
struct NormalFilterOptions {
  double rho = 0.9;    ///< a neighbour votes when n_i . n_j > rho; in [0, 1)
  double tau = 0.25;   ///< eigenvalues below this share of their sum become 0; in (0, 1)
  double damping = 3;  ///< share of the old normal against the filtered one; in [0, 1e6]
  /// The eigen-decomposition stops when the off-diagonal entries sum to this; 0 for full precision.
  double eigen_tolerance = 0;
};

/// What becomes of a point for which no neighbour votes.
enum class Voteless { Keep, Zero };

/// Filters normals by voting tensors with binary eigenvalues.
///
/// T_i = mean of n_j n_j^T over the voters; its largest eigenvalue becomes 1, each other 0 if it is
/// below tau and 1 if not; B_i is T_i with the new eigenvalues, and the result is
/// unit(damping n_i + B_i n_i). One dominant eigenvalue means flat, two an edge, three a corner:
/// B_i projects the normal onto the dominant directions.
///
/// A point without a vote keeps its normal (Voteless::Keep) or gets the zero normal, as in the
/// first round of the authors' program (Voteless::Zero). Zero normals neither vote nor change.
///
/// Source: Yadav et al. 2018, vertex-based normal voting tensor and binary eigenvalue optimisation.
/// @throws std::invalid_argument  if sizes differ or an option is out of its range
[[nodiscard]] std::vector<Vec3> filter_normals(Normals normals, const Neighborhoods& neighborhoods,
                                               const NormalFilterOptions& options = {},
                                               Voteless voteless = Voteless::Keep,
                                               const Execution& execution = {});

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// What a point lies on. The numbers are those written to files.
enum class Feature : std::uint8_t {
  Surface = 0,
  Edge = 1,
  Corner = 2,
  Isolated = 3  ///< has nothing near it to be compared with, or is not finite; is never moved
};

/// "surface", "edge", "corner" or "isolated".
[[nodiscard]] std::string_view to_string(Feature feature);

/// Parameters of the classification. Both are without unit.
struct FeatureOptions {
  double rho = 0.9;   ///< a neighbour counts when n_i . n_j > rho; in [0, 1)
  double tau = 0.25;  ///< threshold on the eigenvalues divided by their Euclidean norm; in (0, 1)
  /// The eigen-decomposition of the covariance stops when the off-diagonal entries sum to this, in
  /// squared units of the points; 0 for full precision.
  double eigen_tolerance = 0;
};

/// The class of every point and the frame that its position update needs.
struct FeatureField {
  std::vector<Feature> label;
  std::vector<Vec3> direction;  ///< unit vector along the edge at Edge points, zero elsewhere
};

/// Sorts points into surface, edge and corner by the spectrum of a covariance.
///
/// The covariance C_i runs over the point itself and its neighbours with similar normals. Its
/// eigenvalues l1 >= l2 >= l3, divided by their Euclidean norm, tell: one above tau, an edge along
/// that eigenvector; two, a surface; otherwise a corner. Where C_i = 0 (no neighbour with a similar
/// normal, or all at one place) the point is isolated.
///
/// Source: Yadav et al. 2018, feature classification by weighted covariance.
/// @throws std::invalid_argument  if sizes differ or an option is out of its range
[[nodiscard]] FeatureField classify_features(Points points, Normals normals,
                                             const Neighborhoods& neighborhoods,
                                             const FeatureOptions& options = {},
                                             const Execution& execution = {});

}  // namespace deburr

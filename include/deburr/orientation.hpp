// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "deburr/execution.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Gives neighbouring normals the same side.
///
/// The graph joins every point with its neighbours, weighted 1 - |n_i . n_j|. Along its minimum
/// spanning tree a normal is flipped when its dot product with its parent is negative; where it is
/// 0 the tree tells nothing, and the normal is turned as that of a root. Each connected piece
/// starts from its point of largest z, whose normal is turned to z >= 0 (to y >= 0, then x >= 0,
/// where z is 0). Ties between weights go to the smaller pair of indices, ties between roots to the
/// smaller index.
///
/// The result does not depend on the signs that come in. Zero normals stay zero.
///
/// Source: Yadav et al. 2018, initial normals; after Hoppe et al. 1992. Differs: a graph in several
/// pieces gets a root for each.
/// @throws std::invalid_argument  if points, normals and neighborhoods differ in size
[[nodiscard]] std::vector<Vec3> orient_normals(Points points, Normals normals,
                                               const Neighborhoods& neighborhoods,
                                               const Execution& execution = {});

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"

namespace deburr {

/// Groups of points that stand for all of their points: fits over them cost what the surface has
/// of detail, not what the cloud has of points.
struct SurfaceNodes {
  std::vector<Vec3> measured;     ///< means of the noisy positions
  std::vector<Vec3> places;       ///< means of the positions on the surface, as known so far
  std::vector<Vec3> normals;      ///< unit, or zero
  std::vector<double> weights;    ///< numbers of points whose mean is as sure; empty for 1 each
  std::vector<double> trust;      ///< how surely their points are of this sheet, in (0, 1]
  std::vector<std::uint32_t> of;  ///< the node of each point that went in; empty where it is one

  [[nodiscard]] std::size_t size() const { return places.size(); }
  [[nodiscard]] double weight(std::size_t node) const {
    return weights.empty() ? 1 : weights[node];
  }
};

/// Every point as a node of its own.
/// @param trust  empty for 1 each
SurfaceNodes nodes_of_points(std::vector<Vec3> measured, std::vector<Vec3> places,
                             std::vector<Vec3> normals, std::vector<double> trust = {});

/// Merges what lies in one cell of a grid and has normals of the same part of the sphere: those
/// with the same largest component and sign, cut into bins x bins parts. The grid is measured off
/// the bounding box of the places, so that neither unit nor place matter.
/// @param normals  empty to merge whatever lies in a cell
/// @param weights,trust  empty for 1 each
/// @param cell  side of a cell, > 0
SurfaceNodes merge_into_cells(Points measured, Points places, Normals normals,
                              std::span<const double> weights, std::span<const double> trust,
                              double cell, std::uint32_t bins, const Execution& execution);

}  // namespace deburr

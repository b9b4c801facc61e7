// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "deburr/mesh.hpp"
#include "deburr/synth.hpp"

namespace deburr {

/// A shape and how densely it is sampled.
struct SampledShape {
  TriangleMesh mesh;
  std::vector<double> density;  ///< per triangle, > 0, only relative; empty where it is the same
};

// Solids (src/solid_shapes.cpp): closed, every edge between exactly two triangles.
[[nodiscard]] TriangleMesh cube_mesh();
[[nodiscard]] TriangleMesh sphere_mesh();
[[nodiscard]] TriangleMesh torus_mesh();
[[nodiscard]] TriangleMesh cylinder_mesh();

// Sheets (src/sheet_shapes.cpp): open, every edge between one or two triangles.
[[nodiscard]] TriangleMesh thin_plate_mesh(double thickness);
[[nodiscard]] TriangleMesh bumpy_sheet_mesh();
[[nodiscard]] SampledShape stepped_wall();

/// Any of them, and the machined part.
/// @throws std::invalid_argument  for an option out of its range
[[nodiscard]] SampledShape sampled_shape(Shape shape, const ShapeOptions& options);

/// Adds nu x nv cells of two triangles each, over vertices place(i, j) that count from 0; normals
/// point along (d place / di) x (d place / dj). A direction that is closed ends at its first row.
template <typename Place>
void add_grid(TriangleMesh& mesh, std::size_t nu, std::size_t nv, bool closed_u, bool closed_v,
              const Place& place) {
  const std::size_t first = mesh.vertices.size();
  const std::size_t rows = closed_u ? nu : nu + 1;
  const std::size_t columns = closed_v ? nv : nv + 1;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) mesh.vertices.push_back(place(i, j));
  }
  const auto at = [&](std::size_t i, std::size_t j) {
    return static_cast<std::uint32_t>(first + (i == rows ? 0 : i) * columns +
                                      (j == columns ? 0 : j));
  };
  for (std::size_t i = 0; i < nu; ++i) {
    for (std::size_t j = 0; j < nv; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
}

}  // namespace deburr

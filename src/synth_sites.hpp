// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "box.hpp"
#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "random.hpp"
#include "shapes.hpp"
#include "surface_sampler.hpp"

namespace deburr {

/// Where a point of a scan is taken.
struct Site {
  SurfacePoint at;
  std::uint32_t scanner = 0;  ///< which one sees it
};

inline constexpr std::uint32_t scanner_count = 4;
/// Where the scanners stand: one and a half diagonals from the middle of the box, towards four
/// corners of a cube that form a tetrahedron.
[[nodiscard]] std::array<Vec3, scanner_count> scanner_positions(const Box& box);

/// `count` points that are random but keep apart: of `candidates_per_point` x `count` random ones,
/// the most crowded one is taken out over and over. Candidates on faces that look in opposite
/// directions, e.g. the two sides of a plate, do not crowd each other. Radii follow the density of
/// the shape.
/// Source: Yuksel, Sample elimination for generating Poisson disk sample sets, 2015.
[[nodiscard]] std::vector<Site> poisson_sites(const SampledShape& shape,
                                              const SurfaceSampler& sampler, std::size_t count,
                                              Random& random, const Execution& execution);
inline constexpr std::size_t candidates_per_point = 4;

/// `count` points where rays from the scanners meet the surface first, scanner by scanner, line by
/// line. The rays of each scanner differ by equal angles, in azimuth and in elevation. The angle is
/// made smaller until enough rays meet the surface; a few that are too many are left out at random.
/// @throws DataError  if hardly any ray meets the surface
[[nodiscard]] std::vector<Site> scanner_sites(const TriangleMesh& mesh, std::size_t count,
                                              Random& random, const Execution& execution);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "deburr/mesh.hpp"
#include "deburr/point_cloud.hpp"

namespace deburr {

/// How to sample and disturb a synthetic scan.
struct SynthOptions {
  std::size_t points = 100000;  ///< number of points, >= 1
  double noise = 0.005;         ///< standard deviation of the noise along each axis, as a fraction
                                ///< of the diagonal of the bounding box of the surface, >= 0
  std::uint64_t seed = 1;       ///< the same seed gives the same bits on every machine
};

/// A surface and a noisy scan of it.
struct SyntheticScan {
  PointCloud cloud;    ///< the noisy points
  TriangleMesh truth;  ///< the surface they were sampled from
};

/// A machined part: a block with a slanted face, a step, a through hole (cylinder), a round boss
/// and a fillet along one edge; the other edges and corners are sharp. Sampled uniformly over its
/// triangulated surface, with isotropic Gaussian noise.
/// @throws std::invalid_argument  for an option out of its range
[[nodiscard]] SyntheticScan synthesize_part(const SynthOptions& options = {});

}  // namespace deburr

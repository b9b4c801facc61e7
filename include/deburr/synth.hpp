// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/mesh.hpp"
#include "deburr/point_cloud.hpp"

namespace deburr {

/// Surfaces to scan; docs/synth.md has their dimensions.
enum class Shape : std::uint8_t {
  Part,        ///< a machined part: slanted face, step, through hole, boss, fillet; 100 x 60 x 40
  Cube,        ///< of side 1
  Sphere,      ///< of radius 1
  Torus,       ///< of radii 1 and 0.4
  Cylinder,    ///< of radius 0.5 and height 1.2, with flat ends and sharp rims
  ThinPlate,   ///< two parallel sheets of side 1 that face away from each other, without side walls
  BumpySheet,  ///< a smooth height field over a unit square, with an open boundary
  SteppedWall  ///< four panels with three steps; ten times as dense at one end as at the other
};

/// What a shape leaves open.
struct ShapeOptions {
  /// Distance of the sheets of ThinPlate, as a fraction of the diagonal of its bounding box, in
  /// (0, 1). With N points, k / sqrt(N) puts them k spacings apart.
  double thickness = 0.03;
};

/// The surface as triangles that run counterclockwise seen from outside, with the same bits on
/// every machine. Curved shapes have their vertices on the curved surface; the triangles stay
/// within 1e-5 of the diagonal of the bounding box of it.
/// @throws std::invalid_argument  for an option out of its range
[[nodiscard]] TriangleMesh shape_mesh(Shape shape, const ShapeOptions& options = {});

/// What a length is a multiple of.
enum class NoiseUnit : std::uint8_t {
  Diagonal,  ///< the diagonal of the bounding box of the surface
  Spacing    ///< the mean spacing, sqrt(area / number of points)
};

/// Where noise moves points to. Its root mean square along the axis or axes named is sigma.
enum class NoiseKind : std::uint8_t {
  Isotropic,  ///< Gaussian along every axis
  Normal,     ///< Gaussian along the normal of the surface only
  Impulsive,  ///< a random half of the points stays; of the others, along the normal, sqrt(2) sigma
  Ray         ///< Gaussian along the ray from the scanner to the point
};

/// Where on the surface points are taken.
enum class Sampling : std::uint8_t {
  Uniform,  ///< independent, uniform over the area
  Poisson,  ///< blue noise: random, but never close together
  Scanner   ///< where rays of regular angular grids from four scanners around the surface hit it
};

/// How to sample and disturb a synthetic scan.
struct SynthOptions {
  std::size_t points = 100000;  ///< number of points on the surface, in [1, 2^28]
  double noise = 0.005;         ///< standard deviation of the noise, in noise_unit, >= 0
  NoiseUnit noise_unit = NoiseUnit::Diagonal;
  NoiseKind noise_kind = NoiseKind::Isotropic;
  Sampling sampling = Sampling::Uniform;
  /// Outliers that are added, as a share of `points`, in [0, 1]: uniform in twice the bounding box.
  double outliers = 0;
  /// Outliers that are added in small dense clusters off the surface, likewise.
  double cluster_outliers = 0;
  std::uint64_t seed = 1;  ///< the same seed gives the same bits on every machine
  ShapeOptions shape{};
};

/// A surface and a noisy scan of it. All arrays have one entry per point of the cloud.
struct SyntheticScan {
  PointCloud cloud;                   ///< the noisy points, without normals
  TriangleMesh truth;                 ///< the surface they were sampled from
  std::vector<Vec3> clean;            ///< the points before the noise; outliers as they are
  std::vector<Vec3> normals;          ///< unit normals of the truth at `clean`; 0 for outliers
  std::vector<std::uint8_t> outlier;  ///< 1 for outliers, 0 for points of the surface
  double sigma = 0;                   ///< standard deviation of the noise, in the unit of the truth
  double spacing = 0;                 ///< sqrt(area / points), in the unit of the truth
};

/// A noisy scan of a shape.
///
/// The points of the surface come in random order, or in that of the scan. Where there are
/// outliers, all points are shuffled. A seed stands for the same places at any noise.
///
/// @throws std::invalid_argument  for an option out of its range
/// @throws DataError              where no place is far enough off the surface for a cluster of
///                                outliers
[[nodiscard]] SyntheticScan synthesize(Shape shape, const SynthOptions& options = {},
                                       const Execution& execution = {});

/// A noisy scan of any surface, likewise.
/// @throws std::invalid_argument  for an option out of its range; for a mesh without triangles, or
///                                with a corner that is no vertex or not finite
/// @throws DataError              as above, and for a mesh without area
[[nodiscard]] SyntheticScan synthesize(const TriangleMesh& surface,
                                       const SynthOptions& options = {},
                                       const Execution& execution = {});

/// synthesize(Shape::Part, options).
[[nodiscard]] SyntheticScan synthesize_part(const SynthOptions& options = {});

}  // namespace deburr

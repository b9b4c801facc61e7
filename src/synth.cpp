// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/synth.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "box.hpp"
#include "deburr/error.hpp"
#include "random.hpp"
#include "require.hpp"
#include "shapes.hpp"
#include "surface_check.hpp"
#include "surface_sampler.hpp"
#include "synth_outliers.hpp"
#include "synth_sites.hpp"

namespace deburr {
namespace {

// Clusters of outliers, in spacings, and in standard deviations of the noise.
constexpr double cluster_radius = 1.5;
constexpr double clear_spacings = 6;
constexpr double clear_sigmas = 5;

void check(const SynthOptions& options) {
  require(options.points >= 1, "synth.points", ">= 1", options.points);
  require(options.points <= std::size_t{1} << 31, "synth.points", "<= 2^31", options.points);
  require(std::isfinite(options.noise) && options.noise >= 0, "synth.noise", "finite and >= 0",
          options.noise);
  require(options.outliers >= 0 && options.outliers <= 1, "synth.outliers", "in [0, 1]",
          options.outliers);
  require(options.cluster_outliers >= 0 && options.cluster_outliers <= 1,
          "synth.cluster_outliers", "in [0, 1]", options.cluster_outliers);
}

/// The displacement of a point whose three normal numbers are `g`.
Vec3 displacement(NoiseKind kind, const Vec3& g, const Vec3& normal, const Vec3& ray) {
  switch (kind) {
    case NoiseKind::Isotropic:
      return g;
    case NoiseKind::Normal:
      return g.x * normal;
    case NoiseKind::Impulsive:
      // The sign of another number is a fair coin.
      return g.y < 0 ? Vec3{} : std::sqrt(2.0) * g.x * normal;
    case NoiseKind::Ray:
      return g.x / norm(ray) * ray;
  }
  throw std::invalid_argument(
      fmt::format("synth.noise_kind must be a NoiseKind, got {}", static_cast<int>(kind)));
}

Vec3 draw_gaussians(Random& random) {
  // One after the other, since the order of a call's arguments is not specified.
  Vec3 g;
  g.x = random.gaussian();
  g.y = random.gaussian();
  g.z = random.gaussian();
  return g;
}

/// Adds outliers behind the points of the surface.
void add_outliers(SyntheticScan& scan, std::vector<Vec3> outliers) {
  std::vector<Vec3>& points = scan.cloud.points;
  points.insert(points.end(), outliers.begin(), outliers.end());
  scan.clean.insert(scan.clean.end(), outliers.begin(), outliers.end());
  scan.normals.resize(points.size());
  scan.outlier.resize(points.size(), 1);
}

void shuffle(SyntheticScan& scan, Random& random) {
  for (std::size_t i = scan.cloud.size(); i > 1; --i) {
    const auto j = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
    std::swap(scan.cloud.points[i - 1], scan.cloud.points[j]);
    std::swap(scan.clean[i - 1], scan.clean[j]);
    std::swap(scan.normals[i - 1], scan.normals[j]);
    std::swap(scan.outlier[i - 1], scan.outlier[j]);
  }
}

SyntheticScan scan_of(SampledShape shape, const SynthOptions& options, const Execution&) {
  SyntheticScan scan;
  scan.truth = std::move(shape.mesh);
  const Box box = bounding_box(scan.truth);
  const SurfaceSampler sampler(scan.truth, shape.density);
  if (!(sampler.area() > 0 && std::isfinite(sampler.area()))) {
    throw DataError("the surface has no area, or none that is finite");
  }
  scan.spacing = std::sqrt(sampler.area() / static_cast<double>(options.points));
  scan.sigma = options.noise * (options.noise_unit == NoiseUnit::Spacing
                                    ? scan.spacing
                                    : norm(box.high - box.low));
  Random random(options.seed);
  // Numbers for the noise are drawn at any noise of any kind, so that a seed stands for the same
  // places.
  std::vector<Site> sites(options.points);
  std::vector<Vec3> gaussians(options.points);
  for (std::size_t i = 0; i < options.points; ++i) {
    sites[i].at = sampler.place(random);
    gaussians[i] = draw_gaussians(random);
  }
  const auto scanners = scanner_positions(box);
  scan.cloud.points.resize(options.points);
  scan.clean.resize(options.points);
  scan.normals.resize(options.points);
  scan.outlier.resize(options.points);
  for (std::size_t i = 0; i < options.points; ++i) {
    const auto& [at, scanner] = sites[i];
    scan.clean[i] = at.position;
    scan.normals[i] = triangle_normal(scan.truth, at.triangle);
    scan.cloud.points[i] =
        at.position + scan.sigma * displacement(options.noise_kind, gaussians[i], scan.normals[i],
                                                at.position - scanners.at(scanner));
  }
  if (options.outliers > 0 || options.cluster_outliers > 0) {
    const auto share = [&](double of) {
      return static_cast<std::size_t>(std::llround(of * static_cast<double>(options.points)));
    };
    // Numbers of their own: the points of the surface are the same with and without outliers.
    Random others(options.seed ^ 0x6f75746c69657273);
    const Box wide = outlier_box(box);
    add_outliers(scan, scattered_outliers(share(options.outliers), wide, others));
    add_outliers(scan, clustered_outliers(share(options.cluster_outliers),
                                          cluster_radius * scan.spacing,
                                          clear_spacings * scan.spacing + clear_sigmas * scan.sigma,
                                          scan.truth, wide, others));
    shuffle(scan, others);
  }
  return scan;
}

}  // namespace

SyntheticScan synthesize(Shape shape, const SynthOptions& options, const Execution& execution) {
  check(options);
  require(options.sampling == Sampling::Uniform, "synth.sampling", "Uniform for now",
          static_cast<int>(options.sampling));
  return scan_of(sampled_shape(shape, options.shape), options, execution);
}

SyntheticScan synthesize(const TriangleMesh& surface, const SynthOptions& options,
                         const Execution& execution) {
  check(options);
  check_surface(surface);
  return scan_of({surface, {}}, options, execution);
}

SyntheticScan synthesize_part(const SynthOptions& options) {
  return synthesize(Shape::Part, options);
}

}  // namespace deburr

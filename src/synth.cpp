// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/synth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "box.hpp"
#include "deburr/error.hpp"
#include "mesh_check.hpp"
#include "random.hpp"
#include "require.hpp"
#include "shapes.hpp"
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
  require(options.points <= std::size_t{1} << 28, "synth.points", "<= 2^28", options.points);
  require(std::isfinite(options.noise) && options.noise >= 0, "synth.noise", "finite and >= 0",
          options.noise);
  require(options.outliers >= 0 && options.outliers <= 1, "synth.outliers", "in [0, 1]",
          options.outliers);
  require(options.cluster_outliers >= 0 && options.cluster_outliers <= 1, "synth.cluster_outliers",
          "in [0, 1]", options.cluster_outliers);
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

/// Places on the surface, and three normal numbers for each. These are drawn at any noise of any
/// kind, so that a seed stands for the same places.
struct Draws {
  std::vector<Site> sites;
  std::vector<Vec3> gaussians;
};

Draws draw(const SampledShape& shape, const SurfaceSampler& sampler, const SynthOptions& options,
           Random& random, const Execution& execution) {
  Draws draws;
  switch (options.sampling) {
    case Sampling::Uniform:
      for (std::size_t i = 0; i < options.points; ++i) {
        draws.sites.push_back({sampler.place(random), 0});
        draws.gaussians.push_back(draw_gaussians(random));
      }
      return draws;
    case Sampling::Poisson:
      draws.sites = poisson_sites(shape, sampler, options.points, random, execution);
      break;
    case Sampling::Scanner:
      draws.sites = scanner_sites(shape.mesh, options.points, random, execution);
      break;
    default:
      throw std::invalid_argument(fmt::format("synth.sampling must be a Sampling, got {}",
                                              static_cast<int>(options.sampling)));
  }
  for (std::size_t i = 0; i < draws.sites.size(); ++i) {
    draws.gaussians.push_back(draw_gaussians(random));
  }
  return draws;
}

SyntheticScan scan_of(SampledShape shape, const SynthOptions& options, const Execution& execution) {
  SyntheticScan scan;
  const Box box = bounding_box(shape.mesh);
  const SurfaceSampler sampler(shape.mesh, shape.density);
  if (!(sampler.area() > 0 && std::isfinite(sampler.area()))) {
    throw DataError("the surface has no area, or none that is finite");
  }
  scan.spacing = std::sqrt(sampler.area() / static_cast<double>(options.points));
  scan.sigma = options.noise *
               (options.noise_unit == NoiseUnit::Spacing ? scan.spacing : norm(box.high - box.low));
  Random random(options.seed);
  const auto [sites, gaussians] = draw(shape, sampler, options, random, execution);
  const auto scanners = scanner_positions(box);
  scan.cloud.points.resize(sites.size());
  scan.clean.resize(sites.size());
  scan.normals.resize(sites.size());
  scan.outlier.resize(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const auto& [at, scanner] = sites[i];
    scan.clean[i] = at.position;
    scan.normals[i] = triangle_normal(shape.mesh, at.triangle);
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
    add_outliers(scan,
                 clustered_outliers(share(options.cluster_outliers), cluster_radius * scan.spacing,
                                    clear_spacings * scan.spacing + clear_sigmas * scan.sigma,
                                    shape.mesh, wide, others));
    shuffle(scan, others);
  }
  scan.truth = std::move(shape.mesh);
  return scan;
}

}  // namespace

SyntheticScan synthesize(Shape shape, const SynthOptions& options, const Execution& execution) {
  check(options);
  return scan_of(sampled_shape(shape, options.shape), options, execution);
}

SyntheticScan synthesize(const TriangleMesh& surface, const SynthOptions& options,
                         const Execution& execution) {
  check(options);
  require_surface(surface);
  return scan_of({surface, {}}, options, execution);
}

SyntheticScan synthesize_part(const SynthOptions& options) {
  return synthesize(Shape::Part, options);
}

}  // namespace deburr

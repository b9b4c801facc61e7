// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/synth.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "box.hpp"
#include "part_mesh.hpp"
#include "random.hpp"
#include "require.hpp"

namespace deburr {
namespace {

void check(const SynthOptions& options) {
  require(options.points >= 1, "synth.points", ">= 1", options.points);
  require(std::isfinite(options.noise) && options.noise >= 0, "synth.noise", "finite and >= 0",
          options.noise);
}

/// Draws points uniformly over the area of a mesh.
class SurfaceSampler {
 public:
  explicit SurfaceSampler(const TriangleMesh& mesh) : mesh_(mesh) {
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3& origin = mesh.vertices[a];
      sum += norm(cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin));
      sums_.push_back(sum);
    }
  }

  Vec3 draw(Random& random) const {
    const auto found = std::ranges::upper_bound(sums_, random.uniform() * sums_.back());
    // Rounding can make the product the whole sum.
    const auto last = mesh_.triangles.size() - 1;
    const auto& [a, b, c] =
        mesh_.triangles[std::min(static_cast<std::size_t>(found - sums_.begin()), last)];
    double u = random.uniform();
    double v = random.uniform();
    if (u + v > 1) {  // in the other half of the parallelogram
      u = 1 - u;
      v = 1 - v;
    }
    const Vec3& origin = mesh_.vertices[a];
    return origin + u * (mesh_.vertices[b] - origin) + v * (mesh_.vertices[c] - origin);
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<double> sums_;  ///< of twice the areas, up to and with each triangle
};

}  // namespace

SyntheticScan synthesize_part(const SynthOptions& options) {
  check(options);
  SyntheticScan scan;
  scan.truth = part_mesh();
  const Box box = bounding_box(scan.truth);
  const double sigma = options.noise * norm(box.high - box.low);
  const SurfaceSampler sampler(scan.truth);
  Random random(options.seed);
  scan.cloud.points.resize(options.points);
  for (Vec3& p : scan.cloud.points) {
    // Drawn one after the other, since the order of a call's arguments is not specified. They are
    // drawn without noise, too, so that a seed stands for the same places at any noise.
    const Vec3 place = sampler.draw(random);
    const double x = random.gaussian();
    const double y = random.gaussian();
    const double z = random.gaussian();
    p = place + sigma * Vec3{x, y, z};
  }
  return scan;
}

}  // namespace deburr

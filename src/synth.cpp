// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/synth.hpp"

#include <cmath>

#include "box.hpp"
#include "part_mesh.hpp"
#include "random.hpp"
#include "require.hpp"
#include "surface_sampler.hpp"

namespace deburr {
namespace {

void check(const SynthOptions& options) {
  require(options.points >= 1, "synth.points", ">= 1", options.points);
  require(std::isfinite(options.noise) && options.noise >= 0, "synth.noise", "finite and >= 0",
          options.noise);
}

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

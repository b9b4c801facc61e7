// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "schedule.hpp"

#include <algorithm>
#include <cmath>

#include "require.hpp"

namespace deburr {
namespace {

void validate(const Yadav2018Options& o) {
  require(o.k >= 3, "yadav2018.k", ">= 3", o.k);
  require(o.rounds >= 0, "yadav2018.rounds", ">= 0", o.rounds);
  require(o.rho >= 0 && o.rho < 1, "yadav2018.rho", "in [0, 1)", o.rho);
  require(o.tau > 0 && o.tau < 1, "yadav2018.tau", "in (0, 1)", o.tau);
  // Beyond these bounds a parameter has no more effect, but could overflow.
  require(o.damping >= 0 && o.damping <= 1e6, "yadav2018.damping", "in [0, 1e6]", o.damping);
  require(o.alpha > 0 && o.alpha <= 1, "yadav2018.alpha", "in (0, 1]", o.alpha);
  require(o.epsilon > 0 && o.epsilon <= 1e6, "yadav2018.epsilon", "in (0, 1e6]", o.epsilon);
  require(o.radius > 0 && o.radius <= 1e6, "yadav2018.radius", "in (0, 1e6]", o.radius);
}

void validate(const AutoOptions& o) {
  const auto positive = [](double v, const char* name) {
    require(v > 0 && std::isfinite(v), name, "finite and > 0", v);
  };
  require(o.rounds >= 0, "automatic.rounds", ">= 0", o.rounds);
  require(o.normal_neighbors >= 3, "automatic.normal_neighbors", ">= 3", o.normal_neighbors);
  positive(o.radius, "automatic.radius");
  require(o.max_neighbors >= 3, "automatic.max_neighbors", ">= 3", o.max_neighbors);
  positive(o.position_scale, "automatic.position_scale");
  positive(o.normal_scale, "automatic.normal_scale");
  require(o.step > 0 && o.step <= 1, "automatic.step", "in (0, 1]", o.step);
  positive(o.max_move, "automatic.max_move");
}

}  // namespace

void validate(const DenoiseOptions& options) {
  if (options.method == Method::Yadav2018) {
    validate(options.yadav2018);
  } else {
    validate(options.automatic);
  }
}

Schedule make_schedule(const Yadav2018Options& o, double spacing) {
  // Where the Jacobi iteration of the authors' program ends, whatever the size of the matrix.
  constexpr double eigen_tolerance = 1e-10;
  const double r = o.radius * spacing;
  Schedule s;
  s.rounds = o.rounds;
  s.neighbors.radius = 2.5 * r;
  s.normal_filter = {
      .rho = o.rho, .tau = o.tau, .damping = o.damping, .eigen_tolerance = eigen_tolerance};
  s.features = {.rho = o.rho, .tau = o.tau, .eigen_tolerance = eigen_tolerance};
  s.update.position_scale = r / 2;
  // The published weight of normals has the unit of a length, which is its first known flaw.
  s.update.normal_scale = r / std::sqrt(8.0);
  s.update.step = o.alpha;
  s.update.feature_step = 1;
  s.update.max_move = o.epsilon * spacing;
  s.update.offset = Offset::Projected;
  s.update.quadric = Quadric::Plain;
  s.update.bound = Bound::Reject;
  s.rebuild = o.rebuild;
  s.in_place = o.in_place;
  s.voteless_at_first = Voteless::Zero;
  return s;
}

Schedule make_schedule(const AutoOptions& o, double spacing, double noise) {
  Schedule s;
  s.rounds = o.rounds;
  s.neighbors = {.max_count = o.max_neighbors, .radius = o.radius * spacing};
  s.refit = NormalRefitOptions{.position_scale = o.position_scale * spacing,
                               .normal_scale = o.normal_scale};
  s.update.position_scale = o.position_scale * spacing;
  s.update.normal_scale = o.normal_scale;
  s.update.step = o.step;
  s.update.max_move = o.max_move * noise;
  return s;
}

}  // namespace deburr

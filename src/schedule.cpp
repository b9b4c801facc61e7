// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "schedule.hpp"

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
  require(o.strength >= 1 && o.strength <= 5, "automatic.strength", "in [1, 5]", o.strength);
  require(o.noise >= 0 && std::isfinite(o.noise), "automatic.noise", "finite and >= 0", o.noise);
  require(o.max_move >= 0 && std::isfinite(o.max_move), "automatic.max_move", "finite and >= 0",
          o.max_move);
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

}  // namespace deburr

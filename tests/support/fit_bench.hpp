// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "node_levels.hpp"
#include "sheet_fit.hpp"
#include "support/shapes.hpp"

// Surfaces whose truth is known, ready to be fitted.

namespace deburr {

/// A noisy surface as nodes of all levels; places and normals are the true ones.
struct FitBench {
  double noise;
  NodeLevels levels;
  const SurfaceNodes& fine;
  SheetFitter fitter;

  FitBench(const Sampled& truth, double spacing, double sigma, unsigned seed)
      : noise(sigma),
        levels(nodes_of_points(with_noise(truth.points, sigma, seed), truth.points, truth.normals),
               spacing, sigma),
        fine(levels.nodes(0)),
        fitter(levels, noise) {}
  // The fitter refers to the nodes.
  FitBench(const FitBench&) = delete;
  FitBench& operator=(const FitBench&) = delete;

  /// @param curvature  as if all nodes together told so much; < 0 for nothing
  [[nodiscard]] Sheet fit(std::uint32_t i, std::size_t scale, float curvature) const {
    ScaleChoice choice{.scale = scale, .noise = noise};
    choice.curvature.fill(curvature);
    SheetFitter::Scratch scratch;
    return fitter.fit(i, scratch, choice);
  }
};

/// Random points on a unit square in z = 0 whose middle is 0.
inline Sampled flat_square(std::size_t n, unsigned seed) {
  Random random(seed);
  Sampled square;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = random.uniform() - 0.5;
    square.points.push_back({x, random.uniform() - 0.5, 0});
    square.normals.push_back({0, 0, 1});
  }
  return square;
}

/// z = 0.02 cos(24 x) likewise: as waves, four of them.
inline Sampled wavy_square(std::size_t n, unsigned seed) {
  constexpr double height = 0.02;
  constexpr double waves = 24;
  Sampled square = flat_square(n, seed);
  for (std::size_t i = 0; i < n; ++i) {
    Vec3& p = square.points[i];
    p.z = height * std::cos(waves * p.x);
    const double slope = -height * waves * std::sin(waves * p.x);
    square.normals[i] = (1 / std::sqrt(1 + slope * slope)) * Vec3{-slope, 0, 1};
  }
  return square;
}

}  // namespace deburr

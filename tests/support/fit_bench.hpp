// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kd_tree.hpp"
#include "sheet_fit.hpp"
#include "support/shapes.hpp"
#include "surface_nodes.hpp"

// Surfaces whose truth is known, ready to be fitted.

namespace deburr {

/// A noisy surface as nodes at two resolutions; places and normals are the true ones.
struct FitBench {
  double spacing;
  double noise;
  SurfaceNodes fine;
  SurfaceNodes coarse;
  KdTree fine_tree;
  KdTree coarse_tree;
  SheetFitter fitter;

  FitBench(const Sampled& truth, double point_spacing, double sigma, unsigned seed)
      : spacing(point_spacing),
        noise(sigma),
        fine(nodes_of_points(with_noise(truth.points, sigma, seed), truth.points, truth.normals)),
        coarse(merge_into_cells(fine.measured, fine.places, fine.normals, fine.weights, {},
                                3 * spacing, {})),
        fine_tree(fine.places),
        coarse_tree(coarse.places),
        fitter(fine, fine_tree, coarse, coarse_tree, noise, spacing) {}
  // The fitter refers to the nodes.
  FitBench(const FitBench&) = delete;
  FitBench& operator=(const FitBench&) = delete;

  [[nodiscard]] double points_per_coarse_node() const {
    return static_cast<double>(fine.size()) / static_cast<double>(coarse.size());
  }
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

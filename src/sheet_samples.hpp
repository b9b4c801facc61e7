// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "kd_tree.hpp"
#include "quadric_fit.hpp"
#include "surface_nodes.hpp"
#include "weighted_quadric.hpp"

namespace deburr {

/// What fits over one neighbourhood read of its nodes, in the frame of the sheet: a column for each
/// quantity, since sums run over eight nodes at once. Filled as far as fits reach.
class SheetSamples {
 public:
  static constexpr std::size_t block_size = 8;  ///< samples that are worked on at once

  /// Begins anew with some nodes.
  /// @param found  in ascending order; has to live as long as it is summed over, as the nodes have
  void start(const SurfaceNodes& nodes, const Frame& frame, std::span<const Found> found);
  [[nodiscard]] std::size_t size() const { return found_.size(); }
  /// The squared distance of a sample; they ascend.
  [[nodiscard]] double square(std::size_t i) const { return found_[i].squared_distance; }
  /// Number of samples with squares up to `area`.
  [[nodiscard]] std::size_t count_within(double area) const;

  /// What a sample must have in common with a surface to be of it.
  struct Membership {
    HeightQuadric surface;
    double area;          ///< squared radius of the neighbourhood
    double reach;         ///< height over the surface that makes it foreign
    double normal_reach;  ///< turn of the normal that does
  };
  /// Sums over the first `count` samples, each with its share in the surface found so far: 1 near
  /// it, 0 far from it, level in between, so that noise of samples that belong is not cut off.
  /// Coordinates are divided by the scale of the sums.
  void sum(std::size_t count, const Membership& member, WeightedQuadric& sums);

  /// The variance of a height that comes of what was summed last, for points of variance 1.
  /// @param pull  see WeightedQuadric::Solution
  [[nodiscard]] double variance(const HeightQuadric& pull) const;

 private:
  /// A column of each quantity, for as many samples as there are lanes: a fit reads one after the
  /// other, and none across the lines of the cache.
  struct alignas(block_size * sizeof(double)) Block {
    using Column = std::array<double, block_size>;
    Column x, y;          ///< in the plane
    Column place_height;  ///< of the place
    Column u, v, w;       ///< normal
    Column trust;
    Column square;    ///< squared distance
    Column height;    ///< of the measured position
    Column weight;    ///< number of points
    Column share;     ///< in the sums made last: weight of a single point
    Column measured;  ///< third coordinate, until heights are known
  };
  struct Kernels;
  void fill(std::size_t count);

  const SurfaceNodes* nodes_ = nullptr;
  Frame frame_;
  std::span<const Found> found_;
  std::vector<Block> blocks_;
  std::size_t filled_ = 0;  ///< samples in blocks, in whole lanes
  std::size_t summed_ = 0;  ///< blocks
};

}  // namespace deburr

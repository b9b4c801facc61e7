// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "quadric_fit.hpp"
#include "weighted_quadric.hpp"

namespace deburr {

/// What fits over one neighbourhood read of its nodes, in the frame of the sheet: a column for each
/// quantity, since sums run over eight nodes at once.
class SheetSamples {
 public:
  struct Sample {
    double x, y;          ///< in the plane
    double height;        ///< of the measured position
    double place_height;  ///< of the place
    double weight;        ///< number of points
    double trust;
    double square;  ///< squared distance
    Vec3 normal;    ///< in the frame
  };

  void clear() { size_ = 0; }
  void add(const Sample& sample);
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] double square(std::size_t i) const { return columns_[squares][i]; }
  /// Number of samples with squares up to `area`; squares ascend.
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
  /// Coordinates are divided by the radius.
  void sum(std::size_t count, const Membership& member, WeightedQuadric& sums);

 private:
  enum Column { xs, ys, heights, place_heights, weights, trusts, squares, us, vs, ws, columns };

  std::array<std::vector<double>, columns> columns_;
  std::vector<double> shares_;
  std::size_t size_ = 0;
};

}  // namespace deburr

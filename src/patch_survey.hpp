// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deburr/execution.hpp"
#include "kd_tree.hpp"
#include "surface_patch.hpp"

namespace deburr {

/// Patches about a sample of the points, at sizes that grow as long as they are asked for.
class PatchSurvey {
 public:
  /// @param points  finite and all different; must outlive this object, as must `tree` over them
  PatchSurvey(Points points, const KdTree& tree);

  /// Points in a patch of the given size; sizes are 0, 1, ...
  [[nodiscard]] std::size_t count(std::size_t size) const;
  /// Whether the cloud is large enough for patches of this size.
  [[nodiscard]] bool has_size(std::size_t size) const;
  /// Makes the patches of the next size.
  void add_size(const Execution& execution);
  /// Sizes made so far.
  [[nodiscard]] std::size_t sizes() const { return patches_.size(); }

  /// Places of the sample, each that of a point; near in this order means near in space.
  [[nodiscard]] const std::vector<Vec3>& sample() const { return sample_; }
  /// Every stride-th place of the sample has a patch of this size. A power of two.
  [[nodiscard]] std::size_t stride(std::size_t size) const;
  /// Patch i * stride is patches(size)[i].
  [[nodiscard]] const std::vector<SurfacePatch>& patches(std::size_t size) const {
    return patches_[size];
  }

 private:
  Points points_;
  const KdTree& tree_;
  std::vector<Vec3> sample_;
  std::vector<Vec3> feet_;  ///< where the patches of the last size have found the surface
  std::vector<std::vector<SurfacePatch>> patches_;
};

}  // namespace deburr

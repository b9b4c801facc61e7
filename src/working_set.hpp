// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/point_cloud.hpp"

namespace deburr {

/// Which points of a cloud are worked on, and in which coordinates.
struct WorkingSetOptions {
  /// Points at the same place become one; in local coordinates those nearly there as well.
  bool merge_duplicates = true;
  bool local_coordinates = true;  ///< about the middle of the cloud, its half extent in [1, 2)
  bool sweep = false;             ///< whether the order of the cloud is wanted
};

/// The points of a cloud that can be worked on, in spatial order, so that neither the order of the
/// input nor (with local coordinates) its place and unit matter.
struct WorkingSet {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::vector<Vec3> points;
  std::vector<Vec3> normals;         ///< as given, unit or zero; empty where the cloud has none
  std::vector<std::uint32_t> slot;   ///< where each point of the cloud is in `points`, or none
  std::vector<std::uint32_t> sweep;  ///< if wanted: `points` in the order of the cloud
  std::size_t non_finite = 0;
  std::size_t duplicates = 0;
  int exponent = 0;  ///< local lengths times 2^exponent are lengths of the cloud
  double unit = 1;   ///< 2^exponent, which is exact

  /// The position of a cloud's point that was `from` and is now `to`, both in local coordinates.
  [[nodiscard]] Vec3 moved(const Vec3& in_cloud, const Vec3& from, const Vec3& to) const;
  /// A local length in the unit of the cloud.
  [[nodiscard]] double length(double local) const;
};

/// Of points that are finite, all different and of a size near 1, as they are.
WorkingSet set_of_distinct(std::vector<Vec3> points);

WorkingSet make_working_set(const PointCloud& cloud, const WorkingSetOptions& options,
                            const Execution& execution);

}  // namespace deburr

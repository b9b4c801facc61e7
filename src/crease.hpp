// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "deburr/features.hpp"
#include "kd_tree.hpp"
#include "packed_sheet.hpp"
#include "sheet_blend.hpp"
#include "sheet_shares.hpp"

namespace deburr {

/// A point on the surface, with what it lies on.
struct Landing {
  Vec3 place;
  Vec3 normal;
  Feature label = Feature::Surface;
  bool fitted = true;  ///< whether there was a sheet for it
  /// The sheets that it may be of: its own and those that meet it.
  std::array<CutSheet, most_sheets> sheets{};
  std::size_t sheet_count = 1;
};

/// Ends smooth sheets where they meet: a point that landed beyond an edge goes to the edge, to the
/// other sheet or to the corner, whatever is nearest to where it was measured.
class CreaseFinder {
 public:
  /// @param spacing  of the points, for what counts as on an edge
  CreaseFinder(std::span<const PackedSheet> sheets, const BlendScales& scales, double spacing)
      : sheets_(sheets), scales_(scales), spacing_(spacing) {}

  /// Distance from the place of a point within which nodes are to be given to land().
  [[nodiscard]] double reach() const { return 2.5 * scales_.spacing + 2.5 * scales_.noise; }

  /// @param point  where it was measured
  /// @param blend  where it lands on its own sheet
  /// @param near  sheets around it, nearest first, all valid
  [[nodiscard]] Landing land(const Vec3& point, const Blend& blend, std::uint32_t own,
                             std::span<const Found> near) const;

 private:
  /// A plane that stands for a sheet near a point.
  struct Plane {
    Vec3 normal;
    double offset = 0;            ///< dot(normal, x) on it
    double side = 0;              ///< +1 or -1: where the own sheet lies; 0 where on both sides
    bool meets = false;           ///< whether it comes near the own sheet where they cross
    std::vector<Vec3> members{};  ///< places on it, nearest first

    [[nodiscard]] double distance(const Vec3& p) const { return dot(normal, p) - offset; }
  };
  [[nodiscard]] std::vector<Plane> find_planes(const Blend& blend, std::uint32_t own,
                                               std::span<const Found> near) const;
  void find_shares(const Vec3& point, const Plane& self, std::span<const Plane> planes,
                   Landing& landing) const;
  [[nodiscard]] double side_of(const Plane& plane, std::span<const Vec3> members) const;

  std::span<const PackedSheet> sheets_;
  BlendScales scales_;
  double spacing_;
};

}  // namespace deburr

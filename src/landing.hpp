// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "automatic.hpp"
#include "sheet_set.hpp"

namespace deburr {

/// Every point on the sheets that it may be of: first each point of the input on the likeliest, in
/// the order of the input, then what is left of those that may be of others.
struct Shares {
  std::vector<Vec3> measured;
  std::vector<Vec3> places;           ///< on the sheet
  std::vector<Vec3> normals;          ///< of the sheet there
  std::vector<double> trust;          ///< how likely the point is of the sheet, in (0, 1]
  std::vector<std::uint8_t> by_edge;  ///< whether it may be of others too
};

/// How many sheets around a point its landing is made of.
struct SheetsAround {
  std::size_t step = 1;   ///< of the even choice: one of so many nodes has a sheet
  std::size_t nodes = 1;  ///< around a point whose sheets, as far as they have one, it lands on
  /// Of each node, whether its points look at all sheets; empty if none does.
  std::span<const std::uint8_t> by_edge;
};

/// The nodes of level 0 that sheets were fitted to.
struct FittedNodes {
  std::vector<std::uint32_t> of;  ///< the node of each point of the input; empty where it is one
  std::size_t count = 0;
  double spacing = 0;
  /// Where the points of each were measured and taken to lie in the mean, for them to land
  /// together; empty for each to land by itself.
  std::vector<Vec3> measured, places, normals;

  [[nodiscard]] std::uint32_t of_point(std::uint32_t point) const {
    return of.empty() ? point : of[point];
  }
};

/// A place, or where the way to it from where the point was measured is as long as the bound.
Vec3 bounded(const Vec3& place, const Vec3& point, double max_move);

/// Lands every point on the sheets around it: sets its place, its normal and its label.
/// @param lone  whether each point seems to be of no surface; no longer where there is a sheet for
///              it within the bound
/// @param result  with the places so far; a point that nothing was fitted around keeps its own
/// @param shares  if wanted: on which sheets each point may be
void land(const AutomaticInput& input, const FittedNodes& nodes, NodeSheets sheets,
          const SheetsAround& around, std::span<std::uint8_t> lone, AutomaticResult& result,
          Shares* shares, const Execution& execution);

}  // namespace deburr

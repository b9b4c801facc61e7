// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "automatic.hpp"
#include "node_levels.hpp"
#include "sheet.hpp"

namespace deburr {

/// Every point on the sheets that it may be of: first each point of the input on the likeliest, in
/// the order of the input, then what is left of those that may be of others.
struct Shares {
  std::vector<Vec3> measured;
  std::vector<Vec3> places;   ///< on the sheet
  std::vector<Vec3> normals;  ///< of the sheet there
  std::vector<double> trust;  ///< how likely the point is of the sheet, in (0, 1]
};

/// Lands every point on the sheets around it: sets its place, its normal and its label.
/// @param levels  nodes that the points of the input were put into first, in their order
/// @param sheets  of the nodes of level 0
/// @param result  with the places so far; a point that nothing was fitted around keeps its own
Shares land(const AutomaticInput& input, const NodeLevels& levels, std::span<const Sheet> sheets,
            AutomaticResult& result, const Execution& execution);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "deburr/execution.hpp"
#include "deburr/vec3.hpp"
#include "kd_tree.hpp"

namespace deburr {

/// What a cloud of sheets that lie close over each other shows.
struct CloseSheets {
  double sigma = 0;  ///< standard deviation of the noise about each of them
  double gap = 0;    ///< their distance
  bool found = false;
};

/// Looks whether what passes for noise is the distance of two sheets, at least at many of the
/// places.
/// @param resolving  number of points in patches that are larger than that
/// @param sigma  standard deviation of what passes for noise, > 0
CloseSheets find_close_sheets(Points points, const KdTree& tree, std::span<const Vec3> places,
                              std::size_t resolving, double sigma, const Execution& execution);

}  // namespace deburr

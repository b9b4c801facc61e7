// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/features.hpp"
#include "sheet_shares.hpp"

namespace deburr {

/// A point on an edge with the sheets that meet there.
struct EdgePoint {
  std::uint32_t point;
  std::array<CutSheet, most_sheets> sheets;
  std::size_t count;
};

/// Labels points as corners where the edges around them are of three sheets that meet near by.
/// Whether a third sheet is there no point tells alone: its share of the neighbourhood is small,
/// and it may be at a flat angle to one of the two others.
/// @param spacing  of the points
void label_corners(std::span<const EdgePoint> edges, Points places, double spacing,
                   std::vector<Feature>& labels, const Execution& execution);

}  // namespace deburr

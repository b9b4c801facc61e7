// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/las_plan.hpp"

// What a writer of LAS puts before the points.

namespace deburr {

/// What is counted and measured of the points.
struct LasCounts {
  std::size_t points = 0;
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  std::array<std::uint64_t, 256> returns{};  ///< points by return number
};

/// A public header block for a cloud that does not come from LAS: version 1.2, or 1.4 for a point
/// format that needs it.
[[nodiscard]] std::string new_las_header(unsigned format);

/// Gives the records new descriptions of the extra bytes, if they changed, and the comments.
void renew_las_records(std::vector<LasRecord>& records, const LasPlan& plan,
                       const FileLayout& layout, Losses& losses);

/// The header with its counts and places, the records, and the gap behind them.
/// @throws DataError  for more points than the version can count
[[nodiscard]] std::string format_las_head(const std::string& header, unsigned minor,
                                          const LasPlan& plan, const LasGrid& grid,
                                          const LasCounts& counts,
                                          const std::vector<LasRecord>& records,
                                          const std::string& gap);

}  // namespace deburr

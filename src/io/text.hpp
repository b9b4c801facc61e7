// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "io/format.hpp"

namespace deburr {

/// Text is what is left.
[[nodiscard]] Match match_text(std::string_view data);

/// @throws IoError  naming the line
[[nodiscard]] PointCloud read_text(const Source& source);

/// Writes without committing; the name of the format tells the shape of a cloud that does not come
/// from a text file.
/// @return what the format could not hold
[[nodiscard]] std::vector<std::string> write_text(const WriteJob& job);

/// Whether the columns 4 to 6 of a row can be a normal when nothing names them: a unit vector up
/// to three decimals.
[[nodiscard]] inline bool looks_like_unit(const Vec3& v) { return std::abs(norm(v) - 1) <= 1e-3; }

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/atomic_file.hpp"
#include "io/source.hpp"

namespace deburr {

/// @throws IoError  naming the line
[[nodiscard]] PointCloud read_text(const Source& source);

/// Writes to `file` without committing it; the extension of `path` tells the shape of a cloud that
/// does not come from a text file.
/// @return what the format could not hold
[[nodiscard]] std::vector<std::string> write_text(AtomicFile& file,
                                                  const std::filesystem::path& path,
                                                  const PointCloud& cloud,
                                                  const std::function<bool()>& cancelled);

/// Whether the columns 4 to 6 of a row can be a normal when nothing names them: a unit vector up
/// to three decimals.
[[nodiscard]] inline bool looks_like_unit(const Vec3& v) { return std::abs(norm(v) - 1) <= 1e-3; }

}  // namespace deburr

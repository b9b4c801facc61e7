// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/atomic_file.hpp"
#include "io/source.hpp"

namespace deburr {

/// @throws IoError  naming the line or byte
[[nodiscard]] PointCloud read_ply(const Source& source);

/// Writes to `file` without committing it.
/// @return what the format could not hold
[[nodiscard]] std::vector<std::string> write_ply(AtomicFile& file,
                                                 const std::filesystem::path& path,
                                                 const PointCloud& cloud,
                                                 const std::function<bool()>& cancelled);

}  // namespace deburr

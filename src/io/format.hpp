// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "deburr/point_cloud.hpp"
#include "io/source.hpp"

namespace deburr {

/// Reads a file of any known format.
[[nodiscard]] PointCloud parse_cloud(const Source& source);

/// The extension of a path in lower case, with its dot.
[[nodiscard]] std::string lower_extension(const std::filesystem::path& path);

}  // namespace deburr

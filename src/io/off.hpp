// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/format.hpp"

namespace deburr {

[[nodiscard]] Match match_off(std::string_view data);

/// @throws IoError  naming the line or byte
[[nodiscard]] PointCloud read_off(const Source& source);

/// Writes without committing.
/// @return what the format could not hold
[[nodiscard]] std::vector<std::string> write_off(const WriteJob& job);

}  // namespace deburr

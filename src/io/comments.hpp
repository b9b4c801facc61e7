// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "deburr/point_cloud.hpp"

namespace deburr {

/// Appends comments and obj_info of a layout, a line each behind a mark.
void append_comments(std::string& text, const FileLayout& layout, std::string_view mark = "#");

}  // namespace deburr

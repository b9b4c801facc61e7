// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "deburr/denoise.hpp"
#include "deburr/io.hpp"

namespace deburr::cli {

/// What is written for every point besides what came in.
struct AddedFields {
  bool normals = false;
  bool label = false;
  bool displacement = false;
  bool outlier = false;
};

/// What --add asks for. Where new fields have no names, nothing is added unless asked for.
/// @param list  of words between commas, or none; empty for what the format takes
/// @throws std::invalid_argument  for other words
[[nodiscard]] AddedFields parse_added_fields(const std::string& list, const FormatInfo& format);

/// Leaves in the cloud of a result what is to be written, and returns the names of the fields
/// added.
/// @param had_normals  of the cloud that came in, which are always written, with their new values
std::vector<std::string> add_fields(DenoiseResult& result, const AddedFields& add, bool had_normals,
                                    const FormatInfo& format);

}  // namespace deburr::cli

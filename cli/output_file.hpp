// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "deburr/io.hpp"

namespace deburr::cli {

/// Refuses, before any work is done for it, an output that cannot be written.
/// @throws IoError  if its folder does not exist or may not be written to, or if it is a folder
void check_output(const std::string& path);

/// As check_output, for a point cloud.
/// @param format  of --format, may be empty
/// @throws std::invalid_argument  for an extension or a format that write_cloud does not know
FormatInfo check_cloud_output(const std::string& path, const std::string& format = {});

/// @throws std::invalid_argument  for a format of --in-format that read_cloud does not know
void check_in_format(const std::string& format);

/// @throws std::invalid_argument  if points and JSON were to share the standard output
void check_json(const std::string& path, bool json);

/// Refuses two names of one file where one would overwrite the other. Empty names and the standard
/// streams are no files.
/// @throws std::invalid_argument  naming the option
void check_different(const std::string& option, const std::string& path, const std::string& other);

/// The extension of a path in small letters, with its dot.
[[nodiscard]] std::string extension(const std::string& path);

/// @throws IoError  if the file cannot be written
void write_text(const std::string& path, const std::string& text);

}  // namespace deburr::cli

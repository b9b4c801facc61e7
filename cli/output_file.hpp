// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "deburr/io.hpp"

namespace deburr::cli {

/// Refuses, before any work is done for it, an output that cannot be written.
/// @throws IoError  if its folder does not exist or may not be written to, if it is a folder, or an
///                  open stream that cannot be written to
void check_output(const std::string& path);

/// As check_output, for a point cloud.
/// @param format  of --format, may be empty
/// @throws std::invalid_argument  for an extension or a format that write_cloud does not know
FormatInfo check_cloud_output(const std::string& path, const std::string& format = {});

/// @throws std::invalid_argument  for a format of --in-format that read_cloud does not know
void check_in_format(const std::string& format);

/// Refuses a file whose name promises something else than what it would hold. Devices, pipes and
/// streams promise nothing.
/// @param known  extensions in small letters with their dots
/// @param what   a picture
/// @throws std::invalid_argument  naming the option, the path and what can be written
void check_extension(const std::string& option, const std::string& path,
                     const std::vector<std::string>& known, const std::string& what);

/// The extension of a path in small letters, with its dot.
[[nodiscard]] std::string extension(const std::string& path);

}  // namespace deburr::cli

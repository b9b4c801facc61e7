// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

// Which of the paths on a command line are one and the same.
//
// Two paths are the same where they lead to one file through links of any kind, or would: a file
// that is not there yet is known by its folder and its name in there, also below a dangling link.
// Streams that are open already ("-", /dev/stdout, /dev/fd/3) are the same if they are one
// descriptor, or one file or pipe. Devices such as /dev/null can be used more than once.

namespace deburr::cli {

/// A path, and what the user called it by: OUT, --report. An empty path was not given.
struct NamedPath {
  std::string option;
  std::string path;
  bool is_implied = false;  ///< the user gave no path
};

/// What --json prints on stdout; not given without it.
[[nodiscard]] NamedPath json_output(bool json);

/// Whether a path names something that is open already: "-", /dev/stdout, /dev/fd/3.
[[nodiscard]] bool is_open_stream(const std::string& path);

/// Refuses outputs of which one would end up in or instead of another.
/// @throws std::invalid_argument  naming both
void check_apart(const std::vector<NamedPath>& outputs);

/// Refuses outputs that would take the place of an input.
/// @throws std::invalid_argument  naming both
void check_kept(const std::vector<NamedPath>& inputs, const std::vector<NamedPath>& outputs);

/// Refuses inputs that come from one stream, of which the second would be empty.
/// @throws std::invalid_argument  naming both
void check_inputs(const std::vector<NamedPath>& inputs);

}  // namespace deburr::cli

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

// Where a path leads.

namespace deburr {

/// The path at the end of symbolic links, of which nothing need exist: a file that is made under a
/// dangling link is made there. After as many links as a kernel follows, the next one.
[[nodiscard]] std::filesystem::path follow_links(std::filesystem::path path);

/// The number of the open descriptor of this process that a path names, as /dev/stdout, /dev/fd/3
/// and links to them do; it may be closed. Opening such a path would open a file a second time, at
/// its beginning, and fails for a socket; what is meant is the open one, where it stands.
[[nodiscard]] std::optional<int> own_descriptor(std::filesystem::path path);

/// Whether a path goes through a descriptor that any process holds.
[[nodiscard]] bool leads_through_descriptor(std::filesystem::path path);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace deburr::cli {

/// Makes the first SIGINT or SIGTERM set a flag. A second one ends the program at once.
void catch_interrupts();

/// Whether that signal came. May be asked from any thread.
[[nodiscard]] bool interrupted();

}  // namespace deburr::cli

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace deburr::cli {

/// Tells the C library to give large blocks back to the system when they are freed. It keeps them
/// otherwise, since that is quickest, and a quarter of the memory of a run with them.
void give_memory_back();

}  // namespace deburr::cli

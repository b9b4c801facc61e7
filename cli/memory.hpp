// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace deburr::cli {

/// Has the C library give coordinates of so many points back to the system when they are freed. It
/// comes to keep blocks up to 32 MB for itself, and a quarter of the memory of a run with them. To
/// keep none at all takes more time than that is worth.
inline void give_memory_back([[maybe_unused]] std::size_t points) {
#ifdef __GLIBC__
  constexpr std::size_t bytes_of_point = 20;  // less than those of a Vec3, more than of a double
  constexpr std::size_t smallest = std::size_t{1} << 20;
  constexpr std::size_t largest = std::size_t{1} << 24;
  (void)mallopt(M_MMAP_THRESHOLD,
                static_cast<int>(std::clamp(bytes_of_point * points, smallest, largest)));
#endif
}

}  // namespace deburr::cli

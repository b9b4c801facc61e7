// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "large_pages.hpp"

#include <sys/mman.h>

#include <cstdint>

namespace deburr {

void prefer_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  // Below this, memory is shared with other objects and pages are few.
  constexpr std::size_t least = std::size_t{1} << 22;
  if (bytes < least) return;
  constexpr std::size_t page = 4096;
  const std::size_t skipped = (page - reinterpret_cast<std::uintptr_t>(begin) % page) % page;
  (void)::madvise(static_cast<char*>(begin) + skipped, (bytes - skipped) / page * page,
                  MADV_HUGEPAGE);
#endif
}

}  // namespace deburr

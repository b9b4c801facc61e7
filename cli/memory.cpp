// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "memory.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "io/large_pages.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif

// Columns come from the system anew each time, and touching their small pages for the first time
// is a twentieth of a run. Sanitizers bring an operator new of their own.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
void* operator new(std::size_t size) {
  void* const block = std::malloc(std::max<std::size_t>(size, 1));
  if (block == nullptr) throw std::bad_alloc();
  deburr::prefer_large_pages(block, size);
  return block;
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
#endif

namespace deburr::cli {

void give_memory_back() {
#ifdef __GLIBC__
  constexpr int large = 1 << 18;  // bytes
  (void)mallopt(M_MMAP_THRESHOLD, large);
#endif
}

}  // namespace deburr::cli

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace deburr {

/// Asks for large pages for memory that is about to be filled. Most of the time of reading a large
/// file goes into first touches of small ones. A hint: whether it is followed changes no result.
void prefer_large_pages(void* begin, std::size_t bytes);

/// As values.reserve(size), for an empty vector.
template <typename T>
void reserve_large(std::vector<T>& values, std::size_t size) {
  values.reserve(size);
  prefer_large_pages(values.data(), size * sizeof(T));
}

/// As values.resize(size), for an empty vector.
template <typename T>
void resize_large(std::vector<T>& values, std::size_t size) {
  reserve_large(values, size);
  values.resize(size);
}

}  // namespace deburr

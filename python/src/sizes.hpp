// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace deburr::python {

/// A count from Python, where -1 is an integer like any other.
/// @throws std::invalid_argument  for a negative one
[[nodiscard]] inline std::size_t to_size(std::string_view option, std::int64_t count) {
  if (count < 0) {
    throw std::invalid_argument(std::string(option) + " must be >= 0, got " +
                                std::to_string(count));
  }
  return static_cast<std::size_t>(count);
}

}  // namespace deburr::python

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace deburr {

/// Throws std::invalid_argument "<option> must be <range>, got <value>" unless `ok`.
template <typename Value>
void require(bool ok, std::string_view option, std::string_view range, const Value& value) {
  if (!ok) throw std::invalid_argument(fmt::format("{} must be {}, got {}", option, range, value));
}

/// Throws std::invalid_argument unless an array holds one entry per point.
inline void require_size(std::string_view name, std::size_t size, std::size_t points) {
  if (size != points) {
    throw std::invalid_argument(
        fmt::format("{} must have one entry per point ({}), got {}", name, points, size));
  }
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/scalar_type.hpp"
#include "support/same_values.hpp"

namespace deburr {

/// Whether a value survived as one of another type. A float may come back as the double that its
/// digits say.
template <typename A, typename B>
bool is_same_value(const A& before, const B& after) {
  if constexpr (std::is_same_v<A, B>) {
    return same_bits(before, after);
  } else if constexpr (std::is_same_v<A, std::string> || std::is_same_v<B, std::string>) {
    return false;
  } else if constexpr (std::is_integral_v<A> && std::is_integral_v<B>) {
    return std::cmp_equal(before, after);
  } else if constexpr (std::is_integral_v<A>) {
    return static_cast<long double>(before) == static_cast<long double>(after);
  } else {
    return same_bits(before, static_cast<A>(after));
  }
}

/// Whether two attributes say the same, in whatever types.
inline bool say_the_same(const Attribute& before, const Attribute& after) {
  if (before.offsets != after.offsets || value_count(before) != value_count(after)) return false;
  return std::visit(
      [](const auto& x, const auto& y) {
        for (std::size_t i = 0; i < x.size(); ++i) {
          if (!is_same_value(x[i], y[i])) return false;
        }
        return true;
      },
      before.values, after.values);
}

/// Whether a warning has these words.
inline bool are_named(const std::vector<std::string>& warnings, const std::string& words) {
  return std::ranges::any_of(
      warnings, [&](const std::string& w) { return w.find(words) != std::string::npos; });
}

}  // namespace deburr

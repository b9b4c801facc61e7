// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

// Numbers as text, the same in every locale.

namespace deburr {

inline std::string_view without_plus(std::string_view token) {
  const bool signed_twice = token.size() > 1 && (token[1] == '+' || token[1] == '-');
  if (!signed_twice && token.starts_with('+')) token.remove_prefix(1);
  return token;
}

/// The number that the whole token says, rounded to nearest; "nan" and "inf" are numbers, what T
/// cannot hold is none. An integer may be written as "3.0".
template <typename T>
std::optional<T> parse_number(std::string_view token) {
  token = without_plus(token);
  T value{};
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error == std::errc() && stop == end) return value;
  if constexpr (std::integral<T>) {
    const std::optional<double> number = parse_number<double>(token);
    // Up to 2^53, every integer is a double.
    if (number && *number == std::trunc(*number) && std::abs(*number) <= 0x1p53 &&
        std::in_range<T>(static_cast<std::int64_t>(*number))) {
      return static_cast<T>(*number);
    }
  } else if (error == std::errc::result_out_of_range && stop == end) {
    // Too small for T is zero; too large is no number.
    const std::size_t exponent = token.find_first_of("eE");
    const bool tiny = exponent != std::string_view::npos
                          ? token.substr(exponent + 1).starts_with('-')
                          : token.starts_with("0.") || token.starts_with("-0.");
    if (tiny) return token.starts_with('-') ? -T{0} : T{0};
  }
  return std::nullopt;
}

/// Whether the token is a number; quick to say no to most that are not.
inline bool is_number(std::string_view token) { return parse_number<double>(token).has_value(); }

/// Whether the token has the form of an integer, of any size.
inline bool is_integer(std::string_view token) {
  if (token.starts_with('+') || token.starts_with('-')) token.remove_prefix(1);
  return !token.empty() && std::ranges::all_of(token, [](char c) { return '0' <= c && c <= '9'; });
}

/// Appends the shortest text that reads back as the same value, without an exponent where that is
/// easy to read.
template <typename T>
void append_number(std::string& text, T value) {
  char buffer[64];
  char* end = nullptr;
  if constexpr (std::floating_point<T>) {
    const T size = std::abs(value);
    const bool plain = size == 0 || (size >= T(1e-5) && size < T(1e15));
    end = plain ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed).ptr
                : std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  } else {
    end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  }
  text.append(buffer, end);
}

}  // namespace deburr

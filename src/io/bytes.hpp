// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

// Numbers as bytes. The caller sees to it that there are enough of them.

namespace deburr {

template <typename T>
T swap_bytes(T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(bytes[i], bytes[sizeof(T) - 1 - i]);
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

inline constexpr bool is_little_endian = std::endian::native == std::endian::little;

/// The number at a place, least byte first.
template <typename T>
T load_little(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return is_little_endian ? value : swap_bytes(value);
}
template <typename T>
T load_little(std::string_view data, std::size_t offset) {
  return load_little<T>(data.data() + offset);
}

template <typename T>
void store_little(char* to, T value) {
  if (!is_little_endian) value = swap_bytes(value);
  std::memcpy(to, &value, sizeof(T));
}
template <typename T>
void store_little(std::string& data, std::size_t offset, T value) {
  store_little(data.data() + offset, value);
}

template <typename T>
void append_little(std::string& data, T value) {
  data.resize(data.size() + sizeof(T));
  store_little(data, data.size() - sizeof(T), value);
}

/// A text in a field of fixed size, which zeros fill.
inline std::string_view padded_text(std::string_view field) {
  return field.substr(0, field.find('\0'));
}

/// The first bytes of a text, with zeros behind them.
inline std::string padded(std::string_view text, std::size_t size) {
  std::string field(text.substr(0, size));
  field.resize(size, '\0');
  return field;
}

}  // namespace deburr

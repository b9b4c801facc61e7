// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "large_pages.hpp"

namespace deburr {

/// Whether a PLY file can hold values of this type.
inline bool is_ply_type(ScalarType type) {
  return type <= ScalarType::UInt32 || type == ScalarType::Float32 || type == ScalarType::Float64;
}

/// Whether values of this type are integers.
inline bool is_integer_type(ScalarType type) { return type <= ScalarType::UInt64; }

/// Calls f(std::type_identity<T>{}) with the T of any type but text.
template <typename F>
decltype(auto) with_number_type(ScalarType type, const F& f) {
  switch (type) {
    case ScalarType::Int8:
      return f(std::type_identity<std::int8_t>{});
    case ScalarType::UInt8:
      return f(std::type_identity<std::uint8_t>{});
    case ScalarType::Int16:
      return f(std::type_identity<std::int16_t>{});
    case ScalarType::UInt16:
      return f(std::type_identity<std::uint16_t>{});
    case ScalarType::Int32:
      return f(std::type_identity<std::int32_t>{});
    case ScalarType::UInt32:
      return f(std::type_identity<std::uint32_t>{});
    case ScalarType::Int64:
      return f(std::type_identity<std::int64_t>{});
    case ScalarType::UInt64:
      return f(std::type_identity<std::uint64_t>{});
    case ScalarType::Float32:
      return f(std::type_identity<float>{});
    case ScalarType::Float64:
      return f(std::type_identity<double>{});
    default:
      throw std::logic_error("not a type of numbers");
  }
}

/// Calls f(std::type_identity<T>{}) with the T of a type that a PLY file can hold.
template <typename F>
decltype(auto) with_ply_type(ScalarType type, const F& f) {
  if (type == ScalarType::Int64 || type == ScalarType::UInt64) {
    throw std::logic_error("not a type of PLY");
  }
  return with_number_type(type, f);
}

/// Size in bytes of a number in a binary file.
inline std::size_t size_of(ScalarType type) {
  return with_number_type(type, []<typename T>(std::type_identity<T>) { return sizeof(T); });
}

/// So many zeros.
inline Values zeros(ScalarType type, std::size_t count) {
  return with_number_type(type, [&]<typename T>(std::type_identity<T>) {
    std::vector<T> values;
    resize_large(values, count);
    return Values(std::move(values));
  });
}

/// No values yet, but memory for so many.
inline Values room_for(ScalarType type, std::size_t count) {
  return with_number_type(type, [&]<typename T>(std::type_identity<T>) {
    std::vector<T> values;
    reserve_large(values, count);
    return Values(std::move(values));
  });
}

/// Number of values that an attribute holds, all lists together.
inline std::size_t value_count(const Attribute& attribute) {
  return std::visit([](const auto& values) { return values.size(); }, attribute.values);
}

}  // namespace deburr

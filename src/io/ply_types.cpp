// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/ply_types.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "io/scalar_type.hpp"

namespace deburr {
namespace {

/// Whether `value` printed with its own number of digits reads the same as a float.
bool float_prints_as(double value) {
  std::array<char, 32> exact;
  std::array<char, 64> narrow;
  const char* const end =
      std::to_chars(exact.begin(), exact.end(), value, std::chars_format::scientific).ptr;
  const std::string_view text(exact.data(), end);
  const auto digits =
      std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find('e')),
                    [](char c) { return '0' <= c && c <= '9'; });
  const char* const narrow_end =
      std::to_chars(narrow.begin(), narrow.end(), static_cast<float>(value),
                    std::chars_format::scientific, static_cast<int>(digits) - 1)
          .ptr;
  return text == std::string_view(narrow.data(), narrow_end);
}

/// From the middle between the largest float and the next power of two on.
constexpr double too_large_for_floats = 0x1.ffffffp127;

/// Whether a number is a float.
bool is_float(double value) {
  return std::abs(value) < too_large_for_floats &&
         static_cast<double>(static_cast<float>(value)) == value;
}

bool holds(ScalarType type, double value, bool is_text) {
  if (type == ScalarType::Float64) return true;
  if (type == ScalarType::Float32) {
    if (!std::isfinite(value) || is_float(value)) return true;
    return is_text && std::abs(value) < too_large_for_floats && float_prints_as(value);
  }
  if (!is_ply_type(type)) return false;
  return with_ply_type(type, [&]<typename T>(std::type_identity<T>) {
    return value >= static_cast<double>(std::numeric_limits<T>::min()) &&
           value <= static_cast<double>(std::numeric_limits<T>::max()) &&
           value == std::trunc(value) && !(value == 0 && std::signbit(value));
  });
}

/// Whether each of the values has the same value in another type.
template <typename T>
bool all_fit(const std::vector<T>& values, ScalarType type) {
  return with_ply_type(type, [&]<typename U>(std::type_identity<U>) {
    return std::ranges::all_of(values, [](T value) {
      if constexpr (std::is_integral_v<U>) {
        return std::in_range<U>(value);
      } else {
        // 2^63 and 2^64 are doubles, but a cast back from them is not defined.
        const auto number = static_cast<double>(value);
        return number < static_cast<double>(std::numeric_limits<T>::max()) &&
               static_cast<T>(number) == value;
      }
    });
  });
}

}  // namespace

bool hold_exactly(const std::vector<Column>& columns, int first_role, bool is_text) {
  const auto is_wanted = [&](const Column& c) {
    return c.role >= first_role && c.role < first_role + 3 && c.type != ScalarType::Float64;
  };
  const auto holds_all = [&](const Column& c, std::size_t begin, std::size_t end) {
    const double Vec3::*const axis = c.axis();
    for (std::size_t i = begin; i < end; ++i) {
      const double value = (*c.vectors)[i].*axis;
      if (c.type == ScalarType::Float32 && is_float(value)) continue;
      if (!holds(c.type, value, is_text)) return false;
    }
    return true;
  };
  const auto first = std::ranges::find_if(columns, is_wanted);
  const std::size_t size = first != columns.end() ? first->vectors->size() : 0;
  // In blocks that stay in the cache while each of the axes is looked at.
  constexpr std::size_t block = 4096;
  for (std::size_t begin = 0; begin < size; begin += block) {
    const std::size_t end = std::min(size, begin + block);
    for (const Column& c : columns) {
      if (is_wanted(c) && !holds_all(c, begin, end)) return false;
    }
  }
  return std::ranges::all_of(columns,
                             [&](const Column& c) { return !is_wanted(c) || is_ply_type(c.type); });
}

std::optional<Attribute> narrow_to_ply(const Attribute& attribute) {
  const auto narrow = [&]<typename T>(const std::vector<T>& values) -> std::optional<Attribute> {
    for (const ScalarType type :
         {ScalarType::UInt8, ScalarType::Int8, ScalarType::UInt16, ScalarType::Int16,
          ScalarType::UInt32, ScalarType::Int32, ScalarType::Float64}) {
      if (!all_fit(values, type)) continue;
      Attribute result{attribute.name, {}, attribute.offsets, attribute.length_type};
      with_ply_type(type, [&]<typename U>(std::type_identity<U>) {
        std::vector<U> converted;
        converted.reserve(values.size());
        for (const T value : values) converted.push_back(static_cast<U>(value));
        result.values = std::move(converted);
      });
      return result;
    }
    return std::nullopt;
  };
  if (const auto* values = std::get_if<std::vector<std::int64_t>>(&attribute.values)) {
    return narrow(*values);
  }
  if (const auto* values = std::get_if<std::vector<std::uint64_t>>(&attribute.values)) {
    return narrow(*values);
  }
  return std::nullopt;
}

ScalarType length_type_of(const Attribute& attribute) {
  std::vector<std::uint64_t> longest{0};
  for (std::size_t i = 1; i < attribute.offsets.size(); ++i) {
    const std::uint64_t length = attribute.offsets[i] - attribute.offsets[i - 1];
    longest[0] = std::max(longest[0], length);
  }
  const bool usable = is_ply_type(attribute.length_type) && is_integer_type(attribute.length_type);
  if (usable && all_fit(longest, attribute.length_type)) return attribute.length_type;
  return longest[0] <= 0xff     ? ScalarType::UInt8
         : longest[0] <= 0xffff ? ScalarType::UInt16
                                : ScalarType::UInt32;
}

}  // namespace deburr

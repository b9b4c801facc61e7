// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/text_column.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/numbers.hpp"
#include "large_pages.hpp"

namespace deburr {

void TextColumn::add(const TextField& field) {
  if (is_stale_) return survey(field.text);
  if (append(field)) return;
  const bool is_first = count_ == 0;
  survey(field.text);
  is_stale_ = !is_first;
  values_ = {};
  if (is_first) (void)append(field);
}

void TextColumn::start_again() {
  is_stale_ = false;
  values_ = {};
  count_ = 0;
}

Values TextColumn::take() {
  if (count_ == 0) return std::vector<std::int64_t>{};
  return std::move(values_);
}

/// Looks at what the type can still be.
void TextColumn::survey(std::string_view token) {
  if (all_integers_) {
    all_integers_ = is_integer(token);
    has_negative_ = has_negative_ || token.starts_with('-');
    if (all_integers_ && parse_number<std::int64_t>(token)) return;
    all_fit_ = false;
    all_fit_unsigned_ = all_fit_unsigned_ && parse_number<std::uint64_t>(token);
  }
  if (all_numbers_) all_numbers_ = is_number(token);
}

/// False for a value that has not the type of the column.
bool TextColumn::append(const TextField& field) {
  switch (type()) {
    case ScalarType::Int64: {
      const std::optional<std::int64_t> value = parse_number<std::int64_t>(field.text);
      has_negative_ = has_negative_ || field.text.starts_with('-');
      return value && is_integer(field.text) && push(*value);
    }
    case ScalarType::UInt64: {
      const std::optional<std::uint64_t> value = parse_number<std::uint64_t>(field.text);
      return value && is_integer(field.text) && !field.text.starts_with('-') && push(*value);
    }
    case ScalarType::Float64: {
      const std::optional<double> value = parse_number<double>(field.text);
      return value && push(*value);
    }
    default:
      // Text for its size alone may still become a number.
      return (!all_numbers_ || is_integer(field.text)) && push(field.str());
  }
}

template <typename T>
bool TextColumn::push(T value) {
  if (count_ == 0) reserve_large(values_.emplace<std::vector<T>>(), rows_);
  std::get<std::vector<T>>(values_).push_back(std::move(value));
  ++count_;
  return true;
}

}  // namespace deburr

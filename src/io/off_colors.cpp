// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/off_colors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "io/numbers.hpp"

namespace deburr {
namespace {

constexpr unsigned most_word = 65535;
constexpr std::size_t digits = 12;

/// Whether the text of a number has just so many digits behind its point.
bool has_digits_of_words(std::string_view token) {
  const std::size_t point = token.find('.');
  if (point == std::string_view::npos || token.size() - point - 1 != digits) return false;
  return is_integer(token.substr(point + 1)) && token[point + 1] != '+' && token[point + 1] != '-';
}

template <typename T>
void append_real(std::string& text, T value) {
  const std::size_t begin = text.size();
  append_number(text, value);
  const std::string_view token = std::string_view(text).substr(begin);
  if (is_integer(token)) {
    text += ".0";
  } else if (has_digits_of_words(token)) {
    text += '0';
  }
}

template <typename T>
std::vector<T> steps(const std::vector<double>& values, double most) {
  std::vector<T> integers;
  integers.reserve(values.size());
  for (const double value : values) integers.push_back(static_cast<T>(std::lround(most * value)));
  return integers;
}

}  // namespace

void append_off_word(std::string& text, unsigned value) {
  fmt::format_to(std::back_inserter(text), "{:.{}f}", static_cast<double>(value) / most_word,
                 digits);
}

void append_off_real(std::string& text, double value) { append_real(text, value); }
void append_off_real(std::string& text, float value) { append_real(text, value); }

void OffColumn::add(std::string_view token, double value) {
  are_bytes_ = are_bytes_ && is_integer(token) && value >= 0 && value <= 255 && token[0] != '-';
  are_words_ = are_words_ && has_digits_of_words(token) && value >= 0 && value <= 1;
  if (are_words_) {
    constexpr double same = 1e-6;  // of a step; the digits are off by less than 1e-7 of it
    const double word = most_word * value;
    are_words_ = std::abs(word - std::round(word)) < same && token[0] != '-';
  }
  values_.push_back(value);
}

Values OffColumn::take(ScalarType type) {
  if (type == ScalarType::UInt8) return steps<std::uint8_t>(values_, 1);
  if (type == ScalarType::UInt16) return steps<std::uint16_t>(values_, most_word);
  return std::move(values_);
}

}  // namespace deburr

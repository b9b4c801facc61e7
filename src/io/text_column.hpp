// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

#include "deburr/point_cloud.hpp"
#include "io/text_split.hpp"

namespace deburr {

/// A column of text that is no coordinate, in the simplest type that holds all values so far:
/// integers, numbers, or text.
class TextColumn {
 public:
  [[nodiscard]] ScalarType type() const {
    if (!all_integers_) return all_numbers_ ? ScalarType::Float64 : ScalarType::Text;
    if (all_fit_) return ScalarType::Int64;
    // Integers too large for any type stay text, which loses nothing.
    return all_fit_unsigned_ && !has_negative_ ? ScalarType::UInt64 : ScalarType::Text;
  }
  /// Whether values were read as another type before, so that all have to be read again.
  [[nodiscard]] bool is_stale() const { return is_stale_; }
  [[nodiscard]] bool all_numbers() const { return all_numbers_; }

  /// Tells how many values will come, at most.
  void expect(std::size_t rows) { rows_ = rows; }
  /// Adds the value of the next row.
  void add(const TextField& field);
  /// Before all rows are added again.
  void start_again();

  [[nodiscard]] Values take();

 private:
  void survey(std::string_view token);
  bool append(const TextField& field);
  template <typename T>
  bool push(T value);

  Values values_;
  std::size_t rows_ = 0;
  std::size_t count_ = 0;
  bool all_integers_ = true;      ///< in form
  bool all_fit_ = true;           ///< the integers, into 64 bits with a sign
  bool all_fit_unsigned_ = true;  ///< the positive ones, into 64 bits without
  bool has_negative_ = false;
  bool all_numbers_ = true;
  bool is_stale_ = false;
};

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"

// Numbers of colours in OFF: integers from 0 to 255, or fractions. Colours of 16 bits are fractions
// with just twelve digits behind the point, which no other numbers are written with.

namespace deburr {

/// Appends a colour of 16 bits as a fraction.
void append_off_word(std::string& text, unsigned value);

/// Appends a real number so that it is read as one.
void append_off_real(std::string& text, double value);
void append_off_real(std::string& text, float value);

/// A column of numbers, in the simplest type that holds all of them.
class OffColumn {
 public:
  void add(std::string_view token, double value);
  /// Whether all are bytes, or all colours of 16 bits.
  [[nodiscard]] bool are_bytes() const { return are_bytes_; }
  [[nodiscard]] bool are_words() const { return are_words_; }
  /// @param type  UInt8, UInt16 or Float64
  [[nodiscard]] Values take(ScalarType type);

 private:
  bool are_bytes_ = true;
  bool are_words_ = true;
  std::vector<double> values_;
};

}  // namespace deburr

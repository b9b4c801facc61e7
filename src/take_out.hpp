// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "columns.hpp"
#include "deburr/execution.hpp"

namespace deburr {

// Some values of a column are left out for a while, in place: a second column would be memory for
// every point of the cloud.

/// Takes the marked values out of the column and returns them. Both keep their order.
/// @param marks  one for each value, not 0 where it goes
template <typename T>
std::vector<T> take_out(std::vector<T>& values, std::span<const std::uint8_t> marks) {
  std::vector<T> taken;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (marks[i] != 0) {
      taken.push_back(std::move(values[i]));
    } else {
      values[kept++] = std::move(values[i]);
    }
  }
  values.resize(kept);
  return taken;
}

/// Undoes take_out().
template <typename T>
void put_back(std::vector<T>& values, std::vector<T> taken, std::span<const std::uint8_t> marks,
              const Execution& execution) {
  std::size_t from = values.size();
  resize_column(values, marks.size(), execution);
  // From the end on, no value is written over before it has moved. Once all are back, the others
  // are where they belong.
  for (std::size_t i = marks.size(); !taken.empty();) {
    if (marks[--i] != 0) {
      values[i] = std::move(taken.back());
      taken.pop_back();
    } else {
      values[i] = std::move(values[--from]);
    }
  }
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace deburr::python {

/// A word in Python and what it stands for; the words are those of the program.
template <typename T>
struct Choice {
  const char* word;
  T value;
};

/// What a word stands for.
/// @throws std::invalid_argument  "<option> must be a, b or c, got 'd'"
template <typename T, std::size_t N>
[[nodiscard]] T parse_word(std::string_view option, std::string_view word,
                           const Choice<T> (&choices)[N]) {
  for (const Choice<T>& choice : choices) {
    if (word == choice.word) return choice.value;
  }
  std::string message(option);
  message += " must be ";
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0) message += i + 1 < N ? ", " : " or ";
    message += choices[i].word;
  }
  throw std::invalid_argument(message + ", got '" + std::string(word) + "'");
}

/// The word for a value.
/// @throws std::logic_error  for a value that the table has been forgotten to tell of
template <typename T, std::size_t N>
[[nodiscard]] const char* word_for(const Choice<T> (&choices)[N], T value) {
  for (const Choice<T>& choice : choices) {
    if (choice.value == value) return choice.word;
  }
  throw std::logic_error("a value without a word");
}

}  // namespace deburr::python

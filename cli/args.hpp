// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

namespace deburr::cli {

/// What every command can be told.
struct CommonArgs {
  int threads = 0;
  bool json = false;
  bool quiet = false;
};

/// Adds --threads, --json, --quiet and --version, and the examples below the help.
void add_common_options(CLI::App& command, CommonArgs& args, const char* examples);

/// Adds a positional file name that must be given.
CLI::Option* add_file(CLI::App& command, const std::string& name, std::string& value,
                      const std::string& description);

/// Adds an option that names a file.
/// @param kind  what the help calls its value: FILE
CLI::Option* add_file_option(CLI::App& command, const std::string& name, std::string& value,
                             const std::string& description, const std::string& kind);

/// What a command that reads a cloud says of its argument.
inline constexpr const char* cloud_help =
    "Point cloud: PLY, LAS, PCD, STL, OBJ, OFF, or text with x y z in each line; - is stdin";

/// Adds --in-format, the format of the cloud that is read.
void add_in_format(CLI::App& command, std::string& format);

/// Adds --format, the format of the cloud that is written.
void add_format(CLI::App& command, std::string& format);

/// The complaint about a number with a minus sign, empty for others; a check for CLI11.
[[nodiscard]] std::string refuse_negative(const std::string& number);

/// The complaint about an empty name of a file; a check for CLI11.
[[nodiscard]] std::string refuse_no_name(const std::string& path);

/// What the library says of an option, "automatic.max_move must be ...", with the name that it has
/// on the command line, "--max-move must be ...". Other messages stay.
[[nodiscard]] std::string with_option_name(const CLI::App& command, const std::string& message);

/// Adds an option whose default is the value that the variable has now.
template <typename T>
CLI::Option* add_value(CLI::App& command, const std::string& name, T& value,
                       const std::string& description) {
  CLI::Option* option = command.add_option(name, value, description);
  // Without this, -1 would become the largest number of the type.
  if constexpr (std::is_unsigned_v<T>) option->check(refuse_negative);
  return option->option_text(
      fmt::format("{} [{}]", std::is_floating_point_v<T> ? "X" : "N", value));
}

/// A word on the command line and what it stands for.
template <typename T>
struct Choice {
  const char* word;
  T value;
};

/// The word for a value; the value must be among the choices.
template <typename T, std::size_t N>
[[nodiscard]] const char* word_for(const Choice<T> (&choices)[N], T value) {
  return std::ranges::find(choices, value, &Choice<T>::value)->word;
}

/// Adds an option that takes one of a few words; its default is the value of the variable now.
template <typename T, std::size_t N>
CLI::Option* add_choice(CLI::App& command, const std::string& name, T& value,
                        const Choice<T> (&choices)[N], const std::string& description) {
  std::vector<std::string> words;
  for (const Choice<T>& choice : choices) words.emplace_back(choice.word);
  return command
      .add_option_function<std::string>(
          name,
          [&value, &choices](const std::string& word) {
            value = std::ranges::find(choices, word, &Choice<T>::word)->value;
          },
          description)
      ->check(CLI::IsMember(words))
      ->option_text(fmt::format("{} [{}]", fmt::join(words, "|"), word_for(choices, value)));
}

}  // namespace deburr::cli

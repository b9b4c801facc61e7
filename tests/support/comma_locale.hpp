// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace deburr {

/// Sets a locale with a decimal comma: one that is installed, or one that is made in a folder.
/// @return false if there is none
inline bool set_comma_locale(const std::filesystem::path& folder) {
  const auto has_comma = [](const char* name) {
    return std::setlocale(LC_ALL, name) != nullptr &&
           std::string(std::localeconv()->decimal_point) == ",";
  };
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "nl_NL.UTF-8"}) {
    if (has_comma(name)) return true;
  }
  const std::filesystem::path made = folder / "de_DE.UTF-8";
  // It grumbles about things that play no role here.
  (void)!std::system(("localedef -i de_DE -f UTF-8 '" + made.string() + "' 2> /dev/null").c_str());
  (void)setenv("LOCPATH", folder.c_str(), 1);
  return has_comma("de_DE.UTF-8");
}

}  // namespace deburr

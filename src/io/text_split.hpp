// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace deburr {

/// One field of a line of text.
struct TextField {
  std::string_view text;   ///< without the quotes around it
  bool is_quoted = false;  ///< a quote inside stands twice in `text`

  [[nodiscard]] std::string str() const;
};

/// The separator of a line of data: ';' or ',' if it makes at least three fields, else '\t' or ' ',
/// which both stand for any run of blanks.
[[nodiscard]] char find_separator(std::string_view line);

/// Splits a line without outer blanks. A field may stand in double quotes.
/// @return false if a quote does not end
[[nodiscard]] bool split(std::string_view line, char separator, std::vector<TextField>& fields);

/// What to say of a file with numbers such as 1,5.
inline constexpr std::string_view decimal_comma_error =
    "decimal commas are not read; write numbers with a point, e.g. 1.5";

/// Whether the token is a number with a decimal comma.
[[nodiscard]] bool is_decimal_comma(std::string_view token);

/// Whether a line of data is made of numbers, some with a decimal comma, and not of fields with a
/// comma between them.
[[nodiscard]] bool has_decimal_commas(std::string_view line);

}  // namespace deburr

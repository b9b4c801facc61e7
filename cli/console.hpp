// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "deburr/execution.hpp"

// Data goes to stdout, talk to stderr.

namespace deburr::cli {

/// Writes data to stdout.
/// @throws IoError  if it did not arrive there (full disk, closed pipe)
void print(std::string_view text);

/// The text as one line, with its end. Control characters, line ends among them, are written as in
/// C: a name can neither end the line nor steer a terminal.
[[nodiscard]] std::string as_line(std::string_view text);

/// The line that warns of something.
[[nodiscard]] std::string warning_line(std::string_view text);

/// Writes a message to stderr. Nothing can be done where that fails.
void tell(const std::string& text);

/// Seconds of a clock that only runs forward.
[[nodiscard]] double steady_seconds();

/// One line on stderr that shows how far the work is, from half a second on; it takes itself away
/// at the end. Shows nothing where stderr is not a terminal.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void update(const Progress& progress);
  /// A callback for a call that is the part [from, to] of the work, under this name.
  [[nodiscard]] std::function<void(const Progress&)> part(std::string_view stage, double from,
                                                          double to);
  void clear();

 private:
  bool enabled_;
  bool visible_ = false;
  double start_;
  double next_;
};

}  // namespace deburr::cli

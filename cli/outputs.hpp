// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "io/atomic_file.hpp"

namespace deburr::cli {

/// What one run writes: all of it appears, or nothing does.
///
/// Until commit(), every file that was there is as it was. What goes to a pipe or a device cannot
/// be taken back, and is on its way as soon as it is written.
class Outputs {
 public:
  /// One more file; "-" is stdout. The reference stays valid.
  /// @throws IoError  if it cannot be written, as all functions here
  [[nodiscard]] AtomicFile& add(const std::string& path) { return files_.emplace_back(path); }

  /// One more file with all that is in it.
  void add(const std::string& path, std::string_view content) { add(path).write(content); }

  /// Puts all files in their places.
  /// @param last  for stdout, which has to arrive there before a file may change
  /// @throws Cancelled  if the user has asked to stop; nothing has changed then
  void commit(std::string_view last = {});

 private:
  std::deque<AtomicFile> files_;  // the last gets its place first
};

}  // namespace deburr::cli

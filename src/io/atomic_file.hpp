// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

namespace deburr {

/// A file that appears whole or not at all.
///
/// The data go to a temporary file in the directory of the target, which commit() renames over the
/// target. Without commit() the temporary is removed and the target is as before. A symbolic link
/// stays, the file that it points to is replaced. What is no regular file (/dev/null, a pipe) is
/// written directly, and so is the standard output, "-".
///
/// All functions throw IoError with the reason of the system.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view data);
  /// Puts the file in its place, once everything is on the disk.
  void commit();

 private:
  [[noreturn]] void fail(std::string_view doing, int error) const;
  void open_temporary(bool replaces, unsigned mode);
  void close();

  std::filesystem::path path_;       ///< as the caller named it, for messages
  std::filesystem::path target_;     ///< the same with links followed
  std::filesystem::path temporary_;  ///< empty when the target is written directly
  int fd_ = -1;
};

}  // namespace deburr

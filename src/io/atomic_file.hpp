// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <string_view>

namespace deburr {

/// A file that appears whole or not at all.
///
/// The data go to a file without a name in the directory of the target, so that nothing is left of
/// it if the program is killed; commit() gives it its name, and renames it over the target if there
/// is one. File systems that have no such files get a temporary one. Without commit() the target is
/// as before. A symbolic link stays, the file that it points to is replaced. What is no regular
/// file (/dev/null, a pipe) is written directly, and so is what is open already: the standard
/// output, "-", and what /dev/stdout or /dev/fd/3 name are written from where they stand.
///
/// All functions throw IoError with the reason of the system.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view data);
  /// Waits until all that was written is on the disk.
  void sync();
  /// Does all but the last step of commit(), and all that needs room: of several files, none
  /// changes unless all of them can be written. Nothing can be written after it.
  void finish();
  /// Puts the file in its place, once everything is on the disk.
  void commit();

 private:
  [[noreturn]] void fail(std::string_view doing, int error) const;
  [[nodiscard]] std::filesystem::path temporary_name(unsigned attempt) const;
  /// @param replaced  the file that it will take the place of, if there is one
  void open_temporary(const struct stat* replaced);
  /// Whether there is a file to be put in a place.
  [[nodiscard]] bool is_direct() const { return !is_nameless_ && temporary_.empty(); }
  [[nodiscard]] bool link_to(const std::filesystem::path& name) const;
  void give_name();
  void end(bool in_place);
  void close();

  std::filesystem::path path_;       ///< as the caller named it, for messages
  std::filesystem::path target_;     ///< the same with links followed
  std::filesystem::path temporary_;  ///< empty while there is none
  int fd_ = -1;
  bool is_nameless_ = false;  ///< until it is whole
};

}  // namespace deburr

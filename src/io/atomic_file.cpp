// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "deburr/error.hpp"

namespace deburr {
namespace {

/// Follows links by hand, because the file at their end need not exist.
std::filesystem::path follow_links(std::filesystem::path path) {
  std::error_code error;
  for (int i = 0; i < 40 && std::filesystem::is_symlink(path, error); ++i) {
    path = path.parent_path() / std::filesystem::read_symlink(path, error);
  }
  return path;
}

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : path_(path), target_(path) {
  if (path == "-") {
    path_ = "standard output";
    // A copy, so that closing tells of errors and leaves the caller's alone.
    fd_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    if (fd_ < 0) fail("cannot write", errno);
    return;
  }
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail("cannot write", errno);
  if (exists && S_ISDIR(status.st_mode)) fail("cannot write", EISDIR);
  // /dev/stdout can lead to a regular file, which the shell holds open and must not lose.
  if (exists && (!S_ISREG(status.st_mode) || path.native().starts_with("/dev/"))) {
    fd_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd_ < 0) fail("cannot write", errno);
    return;
  }
  // Renaming would replace a file that is protected against writing.
  if (exists && ::access(path.c_str(), W_OK) != 0) fail("cannot write", errno);
  target_ = follow_links(path);
  open_temporary(exists, status.st_mode & 07777);
}

AtomicFile::~AtomicFile() {
  if (fd_ >= 0) ::close(fd_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::fail(std::string_view doing, int error) const {
  throw IoError(path_, fmt::format("{}: {}", doing, std::generic_category().message(error)));
}

void AtomicFile::open_temporary(bool replaces, unsigned mode) {
  for (unsigned attempt = 0; fd_ < 0; ++attempt) {
    const std::filesystem::path name =
        target_.parent_path() / fmt::format(".deburr-{}-{}.tmp", ::getpid(), attempt);
    fd_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd_ < 0 && errno != EEXIST) fail("cannot make a file in its directory", errno);
    if (fd_ >= 0) temporary_ = name;
  }
  if (replaces && ::fchmod(fd_, mode) != 0) {
    const int error = errno;
    // A constructor that throws is not followed by the destructor.
    ::close(fd_);
    ::unlink(temporary_.c_str());
    fail("cannot keep its permissions", error);
  }
}

void AtomicFile::write(std::string_view data) {
  while (!data.empty()) {
    const ssize_t written = ::write(fd_, data.data(), data.size());
    if (written < 0 && errno != EINTR) fail("cannot write", errno);
    if (written > 0) data.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AtomicFile::close() {
  if (::close(std::exchange(fd_, -1)) != 0) fail("cannot write", errno);
}

void AtomicFile::commit() {
  if (temporary_.empty()) return close();
  if (::fsync(fd_) != 0) fail("cannot write", errno);
  close();
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot replace", errno);
  temporary_.clear();
}

}  // namespace deburr

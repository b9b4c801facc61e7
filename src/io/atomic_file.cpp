// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <utility>

#include "deburr/error.hpp"

namespace deburr {
namespace {

constexpr int most_links = 40;  ///< as in the kernel

/// One step of following a link, by hand, because the file at its end need not exist.
std::filesystem::path step_along(const std::filesystem::path& link) {
  std::error_code error;
  return link.parent_path() / std::filesystem::read_symlink(link, error);
}

bool is_link(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_symlink(path, error);
}

std::filesystem::path follow_links(std::filesystem::path path) {
  for (int i = 0; i < most_links && is_link(path); ++i) path = step_along(path);
  return path;
}

/// Whether a path goes through a descriptor that some process holds, as /dev/stdout does.
bool leads_through_descriptor(std::filesystem::path path) {
  for (int i = 0; i < most_links && is_link(path); ++i) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::canonical(path.parent_path(), error);
    if (folder.filename() == "fd" && folder.native().starts_with("/proc/")) return true;
    path = step_along(path);
  }
  return false;
}

/// The path by which a file that has no name can be given one.
std::string path_of(int fd) { return fmt::format("/proc/self/fd/{}", fd); }

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
  if (exists && (!S_ISREG(status.st_mode) || leads_through_descriptor(path))) {
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

std::filesystem::path AtomicFile::temporary_name(unsigned attempt) const {
  return target_.parent_path() / fmt::format(".deburr-{}-{}.tmp", ::getpid(), attempt);
}

void AtomicFile::open_temporary(bool replaces, unsigned mode) {
#ifdef O_TMPFILE
  // Without a name, nothing is left over when the program is killed. Not every file system can.
  const std::filesystem::path folder = target_.parent_path();
  fd_ = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (fd_ >= 0 && ::access(path_of(fd_).c_str(), F_OK) != 0) ::close(std::exchange(fd_, -1));
#endif
  is_nameless_ = fd_ >= 0;
  for (unsigned attempt = 0; fd_ < 0; ++attempt) {
    const std::filesystem::path name = temporary_name(attempt);
    fd_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd_ < 0 && errno != EEXIST) fail("cannot make a file in its directory", errno);
    if (fd_ >= 0) temporary_ = name;
  }
  if (replaces && ::fchmod(fd_, mode) != 0) {
    const int error = errno;
    // A constructor that throws is not followed by the destructor.
    ::close(fd_);
    if (!is_nameless_) ::unlink(temporary_.c_str());
    fail("cannot keep its permissions", error);
  }
}

void AtomicFile::give_name() {
  const std::string source = path_of(fd_);
  const auto link_to = [&](const std::filesystem::path& name) {
    return ::linkat(AT_FDCWD, source.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
  };
  if (link_to(target_)) return;
  // A link does not replace a file, but a file with a name does.
  for (unsigned attempt = 0; errno == EEXIST; ++attempt) {
    const std::filesystem::path name = temporary_name(attempt);
    if (!link_to(name)) continue;
    temporary_ = name;
    return;
  }
  fail("cannot make a file in its directory", errno);
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
  const bool is_direct = !is_nameless_ && temporary_.empty();
  if (is_direct) return close();
  if (::fsync(fd_) != 0) fail("cannot write", errno);
  if (is_nameless_) give_name();
  close();
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot replace", errno);
  temporary_.clear();
}

}  // namespace deburr

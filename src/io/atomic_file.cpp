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
#include "io/links.hpp"

namespace deburr {
namespace {

/// The path by which a file that has no name can be given one.
std::string path_of(int fd) { return fmt::format("/proc/self/fd/{}", fd); }

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path) : path_(path), target_(path) {
  if (path == "-") path_ = "standard output";
  if (const std::optional<int> open = path == "-" ? STDOUT_FILENO : own_descriptor(path)) {
    // A copy, so that closing tells of errors and leaves the caller's alone.
    fd_ = ::fcntl(*open, F_DUPFD_CLOEXEC, 3);
    if (fd_ < 0) fail("cannot write", errno);
    return;
  }
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  if (!exists && errno != ENOENT) fail("cannot write", errno);
  if (exists && S_ISDIR(status.st_mode)) fail("cannot write", EISDIR);
  // A regular file that another process holds open must not be lost to it.
  if (exists && (!S_ISREG(status.st_mode) || leads_through_descriptor(path))) {
    fd_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (fd_ < 0) fail("cannot write", errno);
    return;
  }
  // Renaming would replace a file that is protected against writing.
  if (exists && ::access(path.c_str(), W_OK) != 0) fail("cannot write", errno);
  target_ = follow_links(path);
  open_temporary(exists ? &status : nullptr);
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

void AtomicFile::open_temporary(const struct stat* replaced) {
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
  // Only root can, and only root would take a file from its owner otherwise. Before the mode, which
  // this may change.
  if (replaced == nullptr) return;
  if (::geteuid() == 0) (void)!::fchown(fd_, replaced->st_uid, replaced->st_gid);
  if (::fchmod(fd_, replaced->st_mode & 07777) != 0) {
    const int error = errno;
    // A constructor that throws is not followed by the destructor.
    ::close(fd_);
    if (!is_nameless_) ::unlink(temporary_.c_str());
    fail("cannot keep its permissions", error);
  }
}

bool AtomicFile::link_to(const std::filesystem::path& name) const {
  return ::linkat(AT_FDCWD, path_of(fd_).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

/// A link does not replace a file, but a file with a name does.
void AtomicFile::give_name() {
  for (unsigned attempt = 0; temporary_.empty(); ++attempt) {
    const std::filesystem::path name = temporary_name(attempt);
    if (link_to(name)) {
      temporary_ = name;
    } else if (errno != EEXIST) {
      fail("cannot make a file in its directory", errno);
    }
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

void AtomicFile::sync() {
  if (fd_ >= 0 && !is_direct() && ::fsync(fd_) != 0) fail("cannot write", errno);
}

void AtomicFile::end(bool in_place) {
  if (fd_ < 0) return;
  sync();
  // Where nothing is in its place, it needs no other name before.
  if (is_nameless_ && !(in_place && link_to(target_))) give_name();
  close();
}

void AtomicFile::finish() { end(false); }

void AtomicFile::commit() {
  end(true);
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot replace", errno);
  temporary_.clear();
}

}  // namespace deburr

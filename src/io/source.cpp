// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/source.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "deburr/error.hpp"
#include "io/links.hpp"
#include "large_pages.hpp"

namespace deburr {
namespace {

/// Closes a file descriptor.
struct Descriptor {
  int fd;
  explicit Descriptor(int opened) : fd(opened) {}
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
};

/// Memory that nobody fills with zeros before a file is read into it.
struct Buffer {
  char* data = nullptr;
  Buffer() = default;
  ~Buffer() { std::free(data); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

  void grow(std::size_t size) {
    void* const grown = std::realloc(data, size);
    if (grown == nullptr) throw std::bad_alloc();
    data = static_cast<char*>(grown);
    prefer_large_pages(data, size);
  }
};

struct Magic {
  std::string_view start;
  std::string_view name;
};

constexpr std::array<Magic, 9> other_formats{{{"ASTM-E57", "an E57 file"},
                                              {"# vtk", "a VTK file"},
                                              {"glTF", "a glTF file"},
                                              {"PK\x03\x04", "a ZIP archive"},
                                              {"\x1f\x8b", "a gzip archive"},
                                              {"\xff\xfe", "UTF-16 text"},
                                              {"\xfe\xff", "UTF-16 text"},
                                              {"<", "XML or HTML"},
                                              {"{", "JSON"}}};

}  // namespace

void Source::check_cancelled() const {
  if (cancelled && cancelled()) throw Cancelled();
}

void Source::fail(const std::string& what) const { throw IoError(path, what); }

Source load(const std::filesystem::path& path, const std::function<bool()>& cancelled) {
  Source source{path, {}, cancelled, {}};
  const auto fail = [&] { source.fail(std::generic_category().message(errno)); };
  const bool is_input = path == "-";
  if (is_input) source.path = "standard input";
  const std::optional<int> open = is_input ? STDIN_FILENO : own_descriptor(path);
  const Descriptor file(open ? ::fcntl(*open, F_DUPFD_CLOEXEC, 3)
                             : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (file.fd < 0 || ::fstat(file.fd, &status) != 0) fail();

  constexpr std::size_t block = std::size_t{1} << 24;
  // One byte more than the file has, so that its end is seen without growing.
  std::size_t room = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) + 1 : block;
  std::size_t size = 0;
  Buffer buffer;
  buffer.grow(room);
  for (;;) {
    source.check_cancelled();
    if (size == room) buffer.grow(room *= 2);
    const ssize_t got = ::read(file.fd, buffer.data + size, std::min(block, room - size));
    if (got == 0) break;
    if (got > 0) size += static_cast<std::size_t>(got);
    if (got < 0 && errno != EINTR) fail();
  }
  source.data = {buffer.data, size};
  source.owner = {std::exchange(buffer.data, nullptr), [](char* data) { std::free(data); }};
  return source;
}

std::string name_of_other_format(std::string_view data) {
  for (const auto& [start, name] : other_formats) {
    if (data.starts_with(start)) return std::string(name);
  }
  const std::string_view head = data.substr(0, 65536);
  return std::any_of(head.begin(), head.end(), is_binary_byte) ? "binary data" : "";
}

}  // namespace deburr

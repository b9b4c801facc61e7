// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/io.hpp"

namespace deburr {

/// The file that a cloud is written to, without a disk, which would have to be waited for.
inline std::string written_in_memory(const PointCloud& cloud, std::string_view format,
                                     std::vector<std::string>* warnings = nullptr) {
  static const int file = memfd_create("deburr", MFD_CLOEXEC);
  if (file < 0 || ftruncate(file, 0) != 0 || lseek(file, 0, SEEK_SET) != 0) {
    throw std::runtime_error("no file in memory");
  }
  std::vector<std::string> said = write_cloud("/dev/fd/" + std::to_string(file), cloud, {}, format);
  if (warnings != nullptr) *warnings = std::move(said);
  std::string data(static_cast<std::size_t>(lseek(file, 0, SEEK_END)), '\0');
  if (pread(file, data.data(), data.size(), 0) != static_cast<ssize_t>(data.size())) {
    throw std::runtime_error("the file in memory cannot be read");
  }
  return data;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "output_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "deburr/error.hpp"
#include "deburr/io.hpp"

namespace deburr::cli {

namespace fs = std::filesystem;

void check_output(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) throw IoError(path, "is a folder");
  if (fs::exists(status) && access(path.c_str(), W_OK) != 0) {
    throw IoError(path, fmt::format("cannot write: {}", std::strerror(errno)));
  }
  if (fs::is_other(status)) return;  // a pipe or a terminal is not replaced
  // Through symbolic links: the file is replaced where they point to.
  const fs::path folder = fs::weakly_canonical(path, ignored).parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0) {
    throw IoError(path, fmt::format("cannot write in its folder: {}", std::strerror(errno)));
  }
}

void check_cloud_output(const std::string& path) {
  if (!is_writable_format(path)) {
    throw std::invalid_argument(fmt::format(
        "{}: the extension tells the format, one of .ply .xyz .txt .csv .asc .pts", path));
  }
  check_output(path);
}

void check_different(const std::string& option, const std::string& path, const std::string& other) {
  if (path.empty() || other.empty()) return;
  std::error_code ignored;
  if (fs::weakly_canonical(path, ignored) == fs::weakly_canonical(other, ignored)) {
    throw std::invalid_argument(fmt::format("{} {} would overwrite {}", option, path, other));
  }
}

std::string extension(const std::string& path) {
  std::string text = fs::path(path).extension().string();
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

void write_text(const std::string& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text << std::flush;
  if (!file) throw IoError(path, std::strerror(errno));
}

}  // namespace deburr::cli

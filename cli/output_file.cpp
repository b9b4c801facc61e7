// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "output_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "deburr/error.hpp"

namespace deburr::cli {

namespace fs = std::filesystem;

void check_output(const std::string& path) {
  if (path == "-") return;
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) throw IoError(path, "is a folder");
  if (fs::exists(status) && access(path.c_str(), W_OK) != 0) {
    throw IoError(path, fmt::format("cannot write: {}", std::strerror(errno)));
  }
  if (fs::is_other(status)) return;  // a pipe or a terminal is not replaced
  // Through symbolic links, also to nowhere: the file is made where they point to.
  fs::path target = path;
  for (int i = 0; i < 40 && fs::is_symlink(target, ignored); ++i) {
    target = target.parent_path() / fs::read_symlink(target, ignored);
  }
  const fs::path folder = target.parent_path();
  if (access(folder.empty() ? "." : folder.c_str(), W_OK | X_OK) != 0) {
    throw IoError(path, fmt::format("cannot write in its folder: {}", std::strerror(errno)));
  }
}

FormatInfo check_cloud_output(const std::string& path, const std::string& format) {
  const std::optional<FormatInfo> info = output_format(path, format);
  const std::string known = fmt::format("{}", fmt::join(format_names(), " "));
  if (!info && !format.empty()) {
    throw std::invalid_argument(fmt::format("--format {}: must be one of {}", format, known));
  }
  if (!info) {
    throw std::invalid_argument(
        fmt::format("{}: the extension tells the format, one of {}; or use --format", path, known));
  }
  check_output(path);
  return *info;
}

void check_in_format(const std::string& format) {
  const std::vector<std::string> known = format_names();
  if (format.empty() || std::ranges::find(known, format) != known.end()) return;
  throw std::invalid_argument(
      fmt::format("--in-format {}: must be one of {}", format, fmt::join(known, " ")));
}

void check_json(const std::string& path, bool json) {
  if (path == "-" && json) {
    throw std::invalid_argument("--json: the points go to the standard output already");
  }
}

void check_different(const std::string& option, const std::string& path, const std::string& other) {
  if (path.empty() || other.empty() || path == "-" || other == "-") return;
  std::error_code ignored;
  if (fs::equivalent(path, other, ignored) ||
      fs::weakly_canonical(path, ignored) == fs::weakly_canonical(other, ignored)) {
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
  std::error_code error;
  const bool directly = fs::is_other(fs::status(path, error));  // a pipe or a terminal
  const fs::path target = fs::weakly_canonical(path, error);
  const fs::path written =
      directly ? fs::path(path) : fs::path(fmt::format("{}.{}.tmp", target.string(), getpid()));
  errno = 0;
  std::ofstream file(written, std::ios::binary);
  file << text << std::flush;
  file.close();
  if (!file) {
    const int reason = errno;
    if (!directly) fs::remove(written, error);
    throw IoError(path, std::strerror(reason));
  }
  if (!directly) fs::rename(written, target);
}

}  // namespace deburr::cli

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "deburr/error.hpp"
#include "io/links.hpp"
#include "places.hpp"

namespace deburr::cli {

namespace fs = std::filesystem;

void check_output(const std::string& path) {
  const bool is_stdout = path == "-";
  if (const std::optional<int> open = is_stdout ? STDOUT_FILENO : own_descriptor(path)) {
    const std::string name = is_stdout ? "standard output" : path;
    const int flags = fcntl(*open, F_GETFL);
    if (flags < 0) throw IoError(name, std::strerror(errno));
    if ((flags & O_ACCMODE) == O_RDONLY) throw IoError(name, "is not open for writing");
    return;
  }
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) throw IoError(path, "is a folder");
  if (fs::exists(status) && access(path.c_str(), W_OK) != 0) {
    throw IoError(path, fmt::format("cannot write: {}", std::strerror(errno)));
  }
  if (fs::is_other(status)) return;  // a pipe or a terminal is not replaced
  const fs::path folder = follow_links(path).parent_path();
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

void check_extension(const std::string& option, const std::string& path,
                     const std::vector<std::string>& known, const std::string& what) {
  std::error_code ignored;
  const bool has_name = !is_open_stream(path) && !fs::is_other(fs::status(path, ignored));
  if (!has_name || std::ranges::find(known, extension(path)) != known.end()) return;
  throw std::invalid_argument(
      fmt::format("{} {}: {} is written as {}", option, path, what, fmt::join(known, " or ")));
}

std::string extension(const std::string& path) {
  std::string text = fs::path(path).extension().string();
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

}  // namespace deburr::cli

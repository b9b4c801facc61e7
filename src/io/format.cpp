// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "io/ply.hpp"
#include "io/ply_header.hpp"
#include "io/text.hpp"

namespace deburr {
namespace {

/// A kind of file. Another one is added by a line in the table below.
struct Format {
  std::span<const std::string_view> extensions;  ///< in lower case, with their dot
  bool (*accepts)(std::string_view data);        ///< whether the data start as such a file does
  PointCloud (*read)(const Source& source);
  std::vector<std::string> (*write)(AtomicFile& file, const std::filesystem::path& path,
                                    const PointCloud& cloud,
                                    const std::function<bool()>& cancelled);
};

constexpr std::array<std::string_view, 1> ply_extensions{".ply"};
constexpr std::array<std::string_view, 5> text_extensions{".xyz", ".txt", ".csv", ".asc", ".pts"};

/// The last one accepts any data.
constexpr std::array<Format, 2> all_formats{
    {{ply_extensions, is_ply, read_ply, write_ply},
     {text_extensions, [](std::string_view) { return true; }, read_text, write_text}}};

const Format* find_format(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  const auto* const found = std::ranges::find_if(all_formats, [&](const Format& f) {
    return std::ranges::find(f.extensions, extension) != f.extensions.end();
  });
  return found == all_formats.end() ? nullptr : found;
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return extension;
}

PointCloud parse_cloud(const Source& source) {
  if (source.data.empty()) source.fail("empty file");
  const auto* const format =
      std::ranges::find_if(all_formats, [&](const Format& f) { return f.accepts(source.data); });
  return format->read(source);
}

PointCloud read_cloud(const std::filesystem::path& path, const std::function<bool()>& cancelled) {
  return parse_cloud(load(path, cancelled));
}

std::vector<std::string> write_cloud(const std::filesystem::path& path, const PointCloud& cloud,
                                     const std::function<bool()>& cancelled) {
  const Format* const format = find_format(path);
  if (format == nullptr) {
    std::string known;
    for (const Format& f : all_formats) known += fmt::format(" {}", fmt::join(f.extensions, " "));
    throw std::invalid_argument(
        fmt::format("output must end in one of{}, got '{}'", known, path.string()));
  }
  AtomicFile file(path);
  std::vector<std::string> warnings = format->write(file, path, cloud, cancelled);
  file.commit();
  return warnings;
}

bool is_writable_format(const std::filesystem::path& path) { return find_format(path) != nullptr; }

}  // namespace deburr

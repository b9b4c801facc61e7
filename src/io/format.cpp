// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "io/fields.hpp"
#include "io/las.hpp"
#include "io/links.hpp"
#include "io/losses.hpp"
#include "io/obj.hpp"
#include "io/off.hpp"
#include "io/pcd.hpp"
#include "io/ply.hpp"
#include "io/stl.hpp"
#include "io/text.hpp"

namespace deburr {
namespace {

constexpr std::array<std::string_view, 1> ply_names{"ply"};
constexpr std::array<std::string_view, 1> las_names{"las"};
constexpr std::array<std::string_view, 1> pcd_names{"pcd"};
constexpr std::array<std::string_view, 1> stl_names{"stl"};
constexpr std::array<std::string_view, 1> obj_names{"obj"};
constexpr std::array<std::string_view, 1> off_names{"off"};
constexpr std::array<std::string_view, 5> text_names{"xyz", "txt", "csv", "asc", "pts"};

/// In the order in which content is looked at. Text comes last: it takes what nothing else wants.
constexpr std::array<Format, 7> all_formats{{
    {ply_names, match_ply, read_ply, write_ply, true},
    {las_names, match_las, read_las, write_las, true},
    {pcd_names, match_pcd, read_pcd, write_pcd, true},
    {stl_names, match_stl, read_stl, write_stl, false},
    {obj_names, match_obj, read_obj, write_obj, false},
    {off_names, match_off, read_off, write_off, false},
    {text_names, match_text, read_text, write_text, false},
}};

/// Editors put it in front of text of any format.
constexpr std::string_view utf8_mark = "\xef\xbb\xbf";

/// What a file is called in messages and in the lookup of its format.
std::string name_of(const std::filesystem::path& path, std::string_view format) {
  if (!format.empty()) return std::string(format);
  std::string extension = lower_extension(path);
  // An open file has no name that could tell.
  const bool is_nameless = extension.empty() && (path == "-" || own_descriptor(path));
  return is_nameless ? "ply" : extension;
}

const Format& known_format(std::string_view name) {
  if (const Format* const format = format_named(name)) return *format;
  throw std::invalid_argument(
      fmt::format("unknown format '{}', known are {}", name, fmt::join(format_names(), " ")));
}

const Format& find_format(const Source& source) {
  const std::string extension = lower_extension(source.path);
  const Format* possible = nullptr;
  for (const Format& format : all_formats) {
    const Match match = format.match(source.data);
    if (match == Match::Sure) return format;
    const bool is_named = std::ranges::find(format.names, extension) != format.names.end();
    if (match == Match::Possible && is_named) possible = &format;
  }
  return possible != nullptr ? *possible : all_formats.back();
}

}  // namespace

void WriteJob::flush(std::string& buffer) const {
  if (cancelled && cancelled()) throw Cancelled();
  file.write(buffer);
  buffer.clear();
}

const Format* format_named(std::string_view name) {
  const auto* const found = std::ranges::find_if(all_formats, [&](const Format& f) {
    return std::ranges::find(f.names, name) != f.names.end();
  });
  return found == all_formats.end() ? nullptr : found;
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return extension.empty() ? extension : extension.substr(1);
}

PointCloud parse_cloud(const Source& source, std::string_view name) {
  const Format* const format = name.empty() ? nullptr : &known_format(name);
  Source content = source;
  while (content.data.starts_with(utf8_mark)) content.data.remove_prefix(utf8_mark.size());
  if (content.data.empty()) source.fail("empty file");
  return (format != nullptr ? *format : find_format(content)).read(content);
}

PointCloud read_cloud(const std::filesystem::path& path, const std::function<bool()>& cancelled,
                      std::string_view format) {
  if (!format.empty()) (void)known_format(format);
  return parse_cloud(load(path, cancelled), format);
}

std::vector<std::string> write_cloud(const std::filesystem::path& path, const PointCloud& cloud,
                                     const std::function<bool()>& cancelled,
                                     std::string_view format) {
  const std::string name = name_of(path, format);
  if (format.empty() && format_named(name) == nullptr) {
    throw std::invalid_argument(fmt::format("output must end in one of .{}, got '{}'",
                                            fmt::join(format_names(), " ."), path.string()));
  }
  (void)known_format(name);
  AtomicFile file(path);
  std::vector<std::string> warnings = write_cloud(file, cloud, cancelled, name);
  file.commit();
  return warnings;
}

std::vector<std::string> write_cloud(AtomicFile& file, const PointCloud& cloud,
                                     const std::function<bool()>& cancelled,
                                     std::string_view format) {
  return known_format(format).write({file, format, cloud, cancelled});
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const Format& f : all_formats) names.insert(names.end(), f.names.begin(), f.names.end());
  return names;
}

std::optional<FormatInfo> output_format(const std::filesystem::path& path,
                                        std::string_view format) {
  const std::string name = name_of(path, format);
  const Format* const row = format_named(name);
  if (row == nullptr) return std::nullopt;
  return FormatInfo{name, row->names_fields};
}

std::vector<std::string> doubts_about(const PointCloud& cloud) {
  std::vector<std::string> names;
  names.reserve(cloud.layout.fields.size());
  for (const Field& field : cloud.layout.fields) names.push_back(field.name);
  const std::size_t x = find_role(find_roles(names), 0);
  if (x == names.size() || cloud.layout.fields[x].type != ScalarType::Float32) return {};
  const double step = coarse_float_step(cloud.points);
  if (step == 0) return {};
  return {
      fmt::format("the coordinates are 32-bit floats, which are {:.2g} apart at values as large as "
                  "these: what is finer was lost before",
                  step)};
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "deburr/mesh.hpp"
#include "deburr/point_cloud.hpp"
#include "io/atomic_file.hpp"
#include "io/source.hpp"

namespace deburr {

/// Whether data are of a format.
enum class Match {
  No,
  Possible,  ///< if the name of the file says so
  Sure
};

/// What a writer is told beside the cloud.
struct WriteJob {
  AtomicFile& file;
  std::string_view format;  ///< the name of the format, which for text tells the separator
  const PointCloud& cloud;
  const std::function<bool()>& cancelled;

  /// Writes the buffer and empties it.
  /// @throws Cancelled  if the caller has asked to stop
  void flush(std::string& buffer) const;
};

/// A kind of file: one reader, one writer, one row in the table of format.cpp.
struct Format {
  std::span<const std::string_view> names;  ///< its extensions in lower case, without their dot
  Match (*match)(std::string_view data);
  PointCloud (*read)(const Source& source);
  /// Writes without committing, and returns what the format could not hold.
  std::vector<std::string> (*write)(const WriteJob& job);
  bool names_fields;  ///< any new field of numbers can be written under its name
};

/// The row of this name, or null.
[[nodiscard]] const Format* format_named(std::string_view name);

/// Reads a file of any known format: the content tells which, then the extension of the path.
/// @param name  of the format, where neither is to be looked at
/// @throws std::invalid_argument  for a name that is not known
[[nodiscard]] PointCloud parse_cloud(const Source& source, std::string_view name = {});

/// As write_cloud of io.hpp, without putting the file in its place.
std::vector<std::string> write_cloud(AtomicFile& file, const PointCloud& cloud,
                                     const std::function<bool()>& cancelled,
                                     std::string_view format);

/// As write_mesh of io.hpp, without putting the file in its place.
/// @throws Cancelled  when cancelled says so
void write_mesh(AtomicFile& file, const TriangleMesh& mesh,
                const std::function<bool()>& cancelled = {});

/// The extension of a path in lower case, without its dot.
[[nodiscard]] std::string lower_extension(const std::filesystem::path& path);

}  // namespace deburr

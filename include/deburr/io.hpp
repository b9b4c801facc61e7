// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "deburr/mesh.hpp"
#include "deburr/point_cloud.hpp"

namespace deburr {

/// What is known of a format that a cloud can be written in.
struct FormatInfo {
  std::string name;              ///< "ply", "las", ...: also the extension of its files
  bool takes_any_field = false;  ///< new fields of numbers can be written under their names
};

/// The names of all formats: ply las pcd stl obj off xyz txt csv asc pts.
[[nodiscard]] std::vector<std::string> format_names();

/// The format that write_cloud would use for these arguments; none for one that is not known.
[[nodiscard]] std::optional<FormatInfo> output_format(const std::filesystem::path& path,
                                                      std::string_view format = {});

/// Reads a point cloud from PLY, LAS, PCD, STL, OBJ, OFF, or text with columns between blanks,
/// commas or semicolons; the content tells which, then the extension.
///
/// Coordinates and normals become doubles, everything else keeps its type. Non-finite
/// coordinates are read as such. Vertices of a mesh are points; its faces are the element "face"
/// of the layout. docs/formats.md has the details.
///
/// @param path       "-" is the standard input; it and what else is open already (/dev/stdin,
///                   /dev/fd/3) is read from where it stands
/// @param cancelled  asked now and then; true makes the call throw Cancelled
/// @param format     one of format_names() where the content is not to be looked at
/// @throws IoError   naming the line or byte, for a file that is missing or malformed
/// @throws std::invalid_argument  for a format that is not known
[[nodiscard]] PointCloud read_cloud(const std::filesystem::path& path,
                                    const std::function<bool()>& cancelled = {},
                                    std::string_view format = {});

/// What may be wrong with a cloud just read, though its file is well formed, one sentence each:
/// coordinates stored as 32-bit floats that are too large for them.
[[nodiscard]] std::vector<std::string> doubts_about(const PointCloud& cloud);

/// Writes a point cloud; the extension tells the format, one of format_names().
///
/// The file appears whole or not at all: it is written beside the target and then renamed over
/// it. A symbolic link keeps pointing where it did, its target is replaced. Devices and pipes are
/// written directly, and what is open already (/dev/stdout, /dev/fd/3) from where it stands. Within
/// a format, encoding, header and comments are those of `cloud.layout`; text without a header keeps
/// exactly the columns of the layout. Coordinates of PLY, OBJ, OFF and text are read back as the
/// same doubles. LAS rounds them once to its grid, of which points that did not move are part;
/// binary STL, and PCD whose input had floats, to 32-bit floats.
///
/// @param path       "-" is the standard output
/// @param cancelled  asked now and then; true makes the call throw Cancelled, the target untouched
/// @param format     where the extension is not to be looked at; PLY without it for "-" and
///                   what is open already, which has no extension
/// @return what the format could not hold, one sentence each
/// @throws IoError   if the file cannot be written; the target is then untouched
/// @throws DataError for coordinates that are not finite in LAS, which has no place for them
/// @throws std::invalid_argument  for an extension or format that is not known, for normals or
///                   attributes whose length is not that of the points, or for two fields of one
///                   name
std::vector<std::string> write_cloud(const std::filesystem::path& path, const PointCloud& cloud,
                                     const std::function<bool()>& cancelled = {},
                                     std::string_view format = {});

/// Reads a triangle mesh from a file with faces; those with more than three corners are split into
/// a fan.
/// @throws IoError  also when there is no face, one with fewer than three corners, or a corner that
///                  is not a vertex
[[nodiscard]] TriangleMesh read_mesh(const std::filesystem::path& path);

/// Reads what a file holds: a mesh if it has at least one face, otherwise a point cloud.
/// @param cancelled  asked now and then; true makes the call throw Cancelled
/// @throws IoError   as read_mesh and read_cloud
[[nodiscard]] std::variant<TriangleMesh, PointCloud> read_mesh_or_cloud(
    const std::filesystem::path& path, const std::function<bool()>& cancelled = {});

/// Writes a triangle mesh as binary PLY with double coordinates, whole or not at all.
/// @throws IoError  if the file cannot be written
/// @throws std::invalid_argument  if a corner is not a vertex
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace deburr

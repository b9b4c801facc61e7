// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "deburr/mesh.hpp"
#include "deburr/point_cloud.hpp"

namespace deburr {

/// Reads a point cloud from a PLY file (ASCII, binary little or big endian) or from
/// text with columns between blanks, commas or semicolons; the content tells which.
///
/// Coordinates and normals become doubles, everything else keeps its type. Non-finite
/// coordinates are read as such. docs/formats.md has the details.
///
/// @param cancelled  asked now and then; true makes the call throw Cancelled
/// @throws IoError   naming the line or byte, for a file that is missing or malformed
[[nodiscard]] PointCloud read_cloud(const std::filesystem::path& path,
                                    const std::function<bool()>& cancelled = {});

/// Writes a point cloud; the extension tells the format (.ply; .xyz .txt .csv .asc .pts).
///
/// The file appears whole or not at all: it is written beside the target and then renamed over
/// it. A symbolic link keeps pointing where it did, its target is replaced. Devices and pipes are
/// written directly. PLY has the encoding of `cloud.layout`, else binary little endian; text
/// without a header keeps exactly the columns of the layout. Coordinates are
/// written so that reading them back gives the same doubles: they keep the type of
/// `cloud.layout` where that holds every value exactly, and are doubles otherwise.
///
/// @param cancelled  asked now and then; true makes the call throw Cancelled, the target untouched
/// @return what the format could not hold, one sentence each
/// @throws IoError   if the file cannot be written; the target is then untouched
/// @throws std::invalid_argument  for an extension that is not known, for normals or attributes
///                   whose length is not that of the points, or for two fields of one name
std::vector<std::string> write_cloud(const std::filesystem::path& path, const PointCloud& cloud,
                                     const std::function<bool()>& cancelled = {});

/// Whether write_cloud knows the extension of `path`.
[[nodiscard]] bool is_writable_format(const std::filesystem::path& path);

/// Reads a triangle mesh from a PLY file; faces with more than three corners are split into a fan.
/// @throws IoError  also when there is no face, one with fewer than three corners, or a corner that
///                  is not a vertex
[[nodiscard]] TriangleMesh read_mesh(const std::filesystem::path& path);

/// Reads what a file holds: a mesh if it is PLY with at least one face, otherwise a point cloud.
/// @param cancelled  asked now and then; true makes the call throw Cancelled
/// @throws IoError   as read_mesh and read_cloud
[[nodiscard]] std::variant<TriangleMesh, PointCloud> read_mesh_or_cloud(
    const std::filesystem::path& path, const std::function<bool()>& cancelled = {});

/// Writes a triangle mesh as binary PLY with double coordinates, whole or not at all.
/// @throws IoError  if the file cannot be written
/// @throws std::invalid_argument  if a corner is not a vertex
void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "io/atomic_file.hpp"
#include "io/faces.hpp"
#include "io/format.hpp"
#include "io/source.hpp"

namespace deburr {
namespace {

/// The corners of all faces, one after the other, as indices of vertices.
std::vector<std::uint32_t> checked_corners(const Source& source, const Attribute& faces,
                                           std::size_t vertices) {
  std::vector<std::uint32_t> corners;
  std::visit(
      [&]<typename T>(const std::vector<T>& values) {
        if constexpr (std::is_integral_v<T>) {
          for (const T value : values) {
            if (!std::in_range<std::uint32_t>(value) || std::cmp_greater_equal(value, vertices)) {
              const auto next = std::ranges::upper_bound(faces.offsets, corners.size());
              source.fail(fmt::format("face {} has vertex {}, but there are {} vertices",
                                      next - faces.offsets.begin(), value, vertices));
            }
            corners.push_back(static_cast<std::uint32_t>(value));
          }
        } else {
          source.fail(fmt::format("the indices '{}' of the faces are not integers", faces.name));
        }
      },
      faces.values);
  return corners;
}

/// The mesh that a file holds.
TriangleMesh to_mesh(const Source& source, PointCloud cloud) {
  const Attribute* const faces = find_faces(cloud.layout);
  if (faces == nullptr || faces->offsets.size() < 2) source.fail("the file has no faces");

  const std::vector<std::uint32_t> corners = checked_corners(source, *faces, cloud.size());
  TriangleMesh mesh;
  mesh.triangles.reserve(faces->offsets.size() - 1);
  for (std::size_t face = 0; face + 1 < faces->offsets.size(); ++face) {
    const std::size_t begin = faces->offsets[face];
    const std::size_t end = faces->offsets[face + 1];
    if (end - begin < 3) {
      source.fail(fmt::format("face {} has {} corners", face + 1, end - begin));
    }
    for (std::size_t k = begin + 2; k < end; ++k) {
      mesh.triangles.push_back({corners[begin], corners[k - 1], corners[k]});
    }
  }
  mesh.vertices = std::move(cloud.points);
  return mesh;
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& path) {
  const Source source = load(path);
  return to_mesh(source, parse_cloud(source));
}

std::variant<TriangleMesh, PointCloud> read_mesh_or_cloud(const std::filesystem::path& path,
                                                          const std::function<bool()>& cancelled) {
  const Source source = load(path, cancelled);
  PointCloud cloud = parse_cloud(source);
  const bool has_faces = std::ranges::any_of(
      cloud.layout.elements, [](const Element& e) { return e.name == "face" && e.size > 0; });
  if (has_faces) return to_mesh(source, std::move(cloud));
  return cloud;
}

void write_mesh(AtomicFile& file, const TriangleMesh& mesh,
                const std::function<bool()>& cancelled) {
  Attribute faces{"vertex_indices", {}, {0}, ScalarType::UInt8};
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= mesh.vertices.size()) {
        throw std::invalid_argument(fmt::format("a triangle has vertex {}, but there are {}",
                                                corner, mesh.vertices.size()));
      }
      corners.push_back(corner);
    }
    faces.offsets.push_back(corners.size());
  }
  // Most programs expect the type int; a larger mesh needs uint.
  if (mesh.vertices.size() <= std::size_t{std::numeric_limits<std::int32_t>::max()}) {
    faces.values = std::vector<std::int32_t>(corners.begin(), corners.end());
  } else {
    faces.values = std::vector<std::uint32_t>(corners.begin(), corners.end());
  }
  PointCloud cloud{mesh.vertices, {}, {}, {}};
  cloud.layout.elements.push_back({"face", mesh.triangles.size(), {std::move(faces)}, false});
  (void)write_cloud(file, cloud, cancelled, "ply");
}

void write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh) {
  AtomicFile file(path);
  write_mesh(file, mesh);
  file.commit();
}

}  // namespace deburr

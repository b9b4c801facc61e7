// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "box.hpp"
#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"
#include "triangle_distance.hpp"

namespace deburr {

/// Where a ray meets a triangle first.
struct RayHit {
  double distance = 0;         ///< along the ray, in lengths of its direction
  std::uint32_t triangle = 0;  ///< of the mesh
  Vec3 point;                  ///< of the triangle
};

/// The triangle nearest to a point; of several at the same distance the first of the mesh.
struct NearestTriangle {
  std::uint32_t triangle;
  double squared_distance;
  Vec3 point;  ///< of the triangle
};

/// A balanced tree of bounding boxes over the triangles of a mesh, to find the nearest one.
class TriangleBvh {
 public:
  /// @param mesh  has at least one and fewer than 2^32 triangles, whose corners are finite vertices
  explicit TriangleBvh(const TriangleMesh& mesh);

  /// Squared distance from a finite point to the nearest triangle.
  [[nodiscard]] double squared_distance(const Vec3& p) const;

  /// That triangle, for a finite point.
  [[nodiscard]] NearestTriangle nearest(const Vec3& p) const;

  /// All triangles no farther than sqrt(squared_radius) from a finite point, appended to the
  /// cleared `found` in ascending order of their indices.
  void within(const Vec3& p, double squared_radius, std::vector<std::uint32_t>& found) const;

  /// The first triangle ahead of `origin` that a ray meets, from either side; of several at the
  /// same distance the first of the mesh. No ray passes between two triangles with a common edge.
  /// @param direction  not 0
  [[nodiscard]] std::optional<RayHit> first_hit(const Vec3& origin, const Vec3& direction) const;

  /// The box of all triangles.
  [[nodiscard]] const Box& box() const { return nodes_.front().box; }

 private:
  /// A node owns triangles_[begin, end); its children, if any, split that at the middle.
  struct Node {
    Box box;
    std::uint32_t begin, end;
    std::uint32_t right;  ///< index of the right child, the left one is next; 0 for a leaf
  };
  struct Item;
  struct Ray;

  void build(std::vector<Item>& items, std::uint32_t begin, std::uint32_t end);
  template <typename Reaches, typename Visit>
  void search(std::uint32_t node, const Vec3& p, const Reaches& reaches, const Visit& visit) const;
  void search(std::uint32_t node, const Ray& ray, std::optional<RayHit>& first) const;

  std::vector<Triangle> triangles_;     ///< along the leaves
  std::vector<std::uint32_t> indices_;  ///< in the mesh, of triangles_
  std::vector<Node> nodes_;
};

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "box.hpp"
#include "deburr/mesh.hpp"
#include "deburr/vec3.hpp"
#include "triangle_distance.hpp"

namespace deburr {

/// A balanced tree of bounding boxes over the triangles of a mesh, to find the nearest one.
class TriangleBvh {
 public:
  /// @param mesh  has at least one and fewer than 2^32 triangles, whose corners are finite vertices
  explicit TriangleBvh(const TriangleMesh& mesh);

  /// Squared distance from a finite point to the nearest triangle.
  [[nodiscard]] double squared_distance(const Vec3& p) const;

 private:
  /// A node owns triangles_[begin, end); its children, if any, split that at the middle.
  struct Node {
    Box box;
    std::uint32_t begin, end;
    std::uint32_t right;  ///< index of the right child, the left one is next; 0 for a leaf
  };
  struct Item;

  void build(std::vector<Item>& items, std::uint32_t begin, std::uint32_t end);
  void search(std::uint32_t node, const Vec3& p, double& nearest) const;

  std::vector<Triangle> triangles_;  ///< along the leaves
  std::vector<Node> nodes_;
};

}  // namespace deburr

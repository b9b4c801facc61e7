// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "triangle_bvh.hpp"

#include <algorithm>
#include <limits>

namespace deburr {
namespace {

constexpr std::uint32_t leaf_size = 4;

}  // namespace

struct TriangleBvh::Item {
  Triangle triangle;
  Vec3 centre;  ///< three times the centroid
  std::uint32_t index;
};

TriangleBvh::TriangleBvh(const TriangleMesh& mesh) {
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::vector<Item> items(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    Triangle& t = items[i].triangle;
    for (std::size_t k = 0; k < 3; ++k) t[k] = mesh.vertices[mesh.triangles[i][k]];
    items[i].centre = t[0] + t[1] + t[2];
    items[i].index = i;
  }
  nodes_.reserve(4 * (mesh.triangles.size() / leaf_size + 1));
  build(items, 0, count);
  triangles_.reserve(count);
  indices_.reserve(count);
  for (const Item& item : items) {
    triangles_.push_back(item.triangle);
    indices_.push_back(item.index);
  }
}

void TriangleBvh::build(std::vector<Item>& items, std::uint32_t begin, std::uint32_t end) {
  Box box;
  Box centres;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const Vec3& corner : items[i].triangle) box.add(corner);
    centres.add(items[i].centre);
  }
  const std::size_t self = nodes_.size();
  nodes_.push_back({box, begin, end, 0});
  if (end - begin <= leaf_size) return;

  const Vec3 extent = centres.high - centres.low;
  const double largest = std::max({extent.x, extent.y, extent.z});
  const double Vec3::*axis = extent.x == largest   ? &Vec3::x
                             : extent.y == largest ? &Vec3::y
                                                   : &Vec3::z;
  const std::uint32_t middle = begin + (end - begin) / 2;
  // The index makes the order, and so the tree, unique.
  std::nth_element(items.begin() + begin, items.begin() + middle, items.begin() + end,
                   [&](const Item& a, const Item& b) {
                     const double va = a.centre.*axis;
                     const double vb = b.centre.*axis;
                     return va != vb ? va < vb : a.index < b.index;
                   });
  build(items, begin, middle);
  nodes_[self].right = static_cast<std::uint32_t>(nodes_.size());
  build(items, middle, end);
}

double TriangleBvh::squared_distance(const Vec3& p) const {
  double nearest = std::numeric_limits<double>::infinity();
  search(
      0, p, [&](double to_box) { return to_box < nearest; },
      [&](std::uint32_t i) {
        nearest = std::min(nearest, deburr::squared_distance(p, triangles_[i]));
      });
  return nearest;
}

NearestTriangle TriangleBvh::nearest(const Vec3& p) const {
  NearestTriangle best{0, std::numeric_limits<double>::infinity(), {}};
  // Boxes at the same distance count, since they may hold a triangle with a smaller index.
  search(
      0, p, [&](double to_box) { return to_box <= best.squared_distance; },
      [&](std::uint32_t i) {
        const NearestOnTriangle found = nearest_on(p, triangles_[i]);
        if (found.squared_distance < best.squared_distance ||
            (found.squared_distance == best.squared_distance && indices_[i] < best.triangle)) {
          best = {indices_[i], found.squared_distance, p + found.offset};
        }
      });
  return best;
}

void TriangleBvh::within(const Vec3& p, double squared_radius,
                         std::vector<std::uint32_t>& found) const {
  found.clear();
  search(
      0, p, [&](double to_box) { return to_box <= squared_radius; },
      [&](std::uint32_t i) {
        if (deburr::squared_distance(p, triangles_[i]) <= squared_radius) {
          found.push_back(indices_[i]);
        }
      });
  std::ranges::sort(found);
}

/// Visits the triangles of every box whose squared distance `reaches` lets pass, nearer ones first.
template <typename Reaches, typename Visit>
void TriangleBvh::search(std::uint32_t node, const Vec3& p, const Reaches& reaches,
                         const Visit& visit) const {
  const Node& n = nodes_[node];
  if (n.right == 0) {
    for (std::uint32_t i = n.begin; i < n.end; ++i) visit(i);
    return;
  }
  std::uint32_t near = node + 1;
  std::uint32_t far = n.right;
  double to_near = deburr::squared_distance(p, nodes_[near].box);
  double to_far = deburr::squared_distance(p, nodes_[far].box);
  if (to_far < to_near) {
    std::swap(near, far);
    std::swap(to_near, to_far);
  }
  if (reaches(to_near)) search(near, p, reaches, visit);
  if (reaches(to_far)) search(far, p, reaches, visit);
}

}  // namespace deburr

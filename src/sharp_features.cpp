// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "deburr/sharp_features.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "mesh_check.hpp"
#include "triangle_normal.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

using Index = std::uint32_t;

/// cos 30 degrees, less what rounding can do to an angle of exactly that.
constexpr double sharp_cosine = 0.86602540378443865 - 1e-6;
static_assert(sharp_angle == 30);

/// A triangle with an area, whose corners are vertices with a place of their own.
struct Face {
  std::array<Index, 3> sorted;
  std::array<Index, 3> corners;
  Vec3 normal;
};

/// One of the three sides of a face.
struct Side {
  Index low, high;  ///< its ends
  bool forward;     ///< whether the face runs from low to high
  Index face;

  [[nodiscard]] auto key() const { return std::tie(low, high, face); }
  [[nodiscard]] bool same_edge(const Side& other) const {
    return low == other.low && high == other.high;
  }
};

/// For every vertex that triangles use, the first one at the same place.
std::vector<Index> merged_vertices(const TriangleMesh& mesh) {
  std::vector<Index> used;
  for (const auto& triangle : mesh.triangles) {
    used.insert(used.end(), triangle.begin(), triangle.end());
  }
  const auto key = [&](Index i) {
    const Vec3& v = mesh.vertices[i];
    return std::tuple(v.x, v.y, v.z, i);
  };
  std::ranges::sort(used, {}, key);
  std::vector<Index> merged(mesh.vertices.size());
  for (std::size_t k = 0; k < used.size(); ++k) {
    const bool same = k > 0 && mesh.vertices[used[k]] == mesh.vertices[used[k - 1]];
    merged[used[k]] = same ? merged[used[k - 1]] : used[k];
  }
  return merged;
}

/// The faces of the surface, each once.
std::vector<Face> distinct_faces(const TriangleMesh& mesh) {
  const std::vector<Index> merged = merged_vertices(mesh);
  std::vector<Face> faces;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Face face{{}, {}, triangle_normal(triangle_of(mesh, i))};
    if (is_zero(face.normal)) continue;
    for (std::size_t k = 0; k < 3; ++k) face.corners[k] = merged[mesh.triangles[i][k]];
    face.sorted = face.corners;
    std::ranges::sort(face.sorted);
    faces.push_back(face);
  }
  std::ranges::stable_sort(faces, {}, &Face::sorted);
  const auto rest = std::ranges::unique(faces, {}, &Face::sorted);
  faces.erase(rest.begin(), rest.end());
  return faces;
}

/// The sides of all faces; those of one edge stand together.
std::vector<Side> sorted_sides(const std::vector<Face>& faces) {
  std::vector<Side> sides;
  sides.reserve(3 * faces.size());
  for (Index f = 0; f < faces.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = faces[f].corners[k];
      const Index to = faces[f].corners[(k + 1) % 3];
      sides.push_back({std::min(from, to), std::max(from, to), from < to, f});
    }
  }
  std::ranges::sort(sides, {}, &Side::key);
  return sides;
}

/// Whether two faces at an edge differ by more than the sharp angle.
bool is_sharp(const std::vector<Face>& faces, const Side& a, const Side& b) {
  const double cosine = dot(faces[a.face].normal, faces[b.face].normal);
  // Faces that run along their edge the same way show different sides.
  return (a.forward == b.forward ? -cosine : cosine) < sharp_cosine;
}

std::vector<std::array<Index, 2>> sharp_edges(const std::vector<Face>& faces) {
  const std::vector<Side> sides = sorted_sides(faces);
  std::vector<std::array<Index, 2>> edges;
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end =
        std::find_if_not(begin, sides.end(), [&](const Side& s) { return s.same_edge(*begin); });
    bool sharp = false;
    for (auto a = begin; a != end && !sharp; ++a) {
      sharp = std::any_of(a + 1, end, [&](const Side& b) { return is_sharp(faces, *a, b); });
    }
    if (sharp) edges.push_back({begin->low, begin->high});
    begin = end;
  }
  return edges;
}

/// Whether a way through `via` turns by more than the sharp angle.
bool turns(const Vec3& from, const Vec3& via, const Vec3& to) {
  const Vec3 in = via - from;
  const Vec3 out = to - via;
  return dot(in, out) < sharp_cosine * norm(in) * norm(out);
}

}  // namespace

SharpFeatures find_sharp_features(const TriangleMesh& surface) {
  require_surface(surface);
  const auto at = [&](Index i) { return surface.vertices[i]; };
  const std::vector<std::array<Index, 2>> edges = sharp_edges(distinct_faces(surface));

  SharpFeatures sharp;
  std::vector<std::array<Index, 2>> ends;  // from each end to the other
  for (const auto& [a, b] : edges) {
    sharp.edges.push_back({at(a), at(b)});
    ends.push_back({a, b});
    ends.push_back({b, a});
  }
  std::ranges::sort(ends);
  for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
    const Index vertex = ends[begin][0];
    while (end < ends.size() && ends[end][0] == vertex) ++end;
    const std::size_t meeting = end - begin;
    if (meeting > 2 ||
        (meeting == 2 && turns(at(ends[begin][1]), at(vertex), at(ends[begin + 1][1])))) {
      sharp.corners.push_back(at(vertex));
    }
  }
  return sharp;
}

}  // namespace deburr

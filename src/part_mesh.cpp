// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "part_mesh.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include "unit_circle.hpp"

namespace deburr {
namespace {

using Index = std::uint32_t;
using Ring = std::vector<Index>;  ///< vertices on a circle, counterclockwise seen from above

constexpr Index quarter = circle_points / 4;

class PartBuilder {
 public:
  TriangleMesh build() {
    // The outline of the block in x and z, seen from the front and counterclockwise.
    std::vector<Vec3> profile{{0, 0, 0}, {width, 0, 0}};
    for (const auto& [cos, sin] : arc_) {
      profile.push_back(
          {width - fillet_radius * (1 - cos), 0, floor_z - fillet_radius * (1 - sin)});
    }
    const auto bottom = Index{0};
    const auto floor = static_cast<Index>(profile.size() - 1);
    const Index top = floor + 2;
    profile.insert(
        profile.end(),
        {{step_x, 0, floor_z}, {step_x, 0, top_z}, {slant_x, 0, top_z}, {0, 0, slant_z}});
    const auto count = static_cast<Index>(profile.size());
    for (const Vec3& p : profile) mesh_.vertices.push_back(p);
    for (const Vec3& p : profile) mesh_.vertices.push_back({p.x, depth, p.z});

    // The whole outline is seen from its first vertex: a fan covers it, in front and behind.
    for (Index i = 1; i + 1 < count; ++i) {
      add(0, i, i + 1);
      add(count, count + i + 1, count + i);
    }
    for (Index i = 0; i < count; ++i) {
      if (i == bottom || i == floor || i == top) continue;
      const Index next = (i + 1) % count;
      add_quad(i, count + i, count + next, next);
    }

    const Ring hole_below = add_circle(hole_centre, hole_radius, 0);
    const Ring hole_above = add_circle(hole_centre, hole_radius, floor_z);
    const Ring boss_below = add_circle(boss_centre, boss_radius, top_z);
    const Ring boss_above = add_circle(boss_centre, boss_radius, boss_z);
    add_plate({count + bottom + 1, count + bottom, bottom, bottom + 1}, hole_below, false);
    add_plate({count + floor, count + floor + 1, floor + 1, floor}, hole_above, true);
    add_plate({count + top, count + top + 1, top + 1, top}, boss_below, true);
    add_wall(hole_above, hole_below);
    add_wall(boss_below, boss_above);
    const Index centre = add_vertex({boss_centre.x, boss_centre.y, boss_z});
    for (Index s = 0; s < circle_points; ++s) {
      add(centre, boss_above[s], boss_above[(s + 1) % circle_points]);
    }
    return std::move(mesh_);
  }

 private:
  // Millimetres.
  static constexpr double width = 100;
  static constexpr double depth = 60;
  static constexpr double floor_z = 16;
  static constexpr double step_x = 60;
  static constexpr double top_z = 30;
  static constexpr double slant_x = 20;
  static constexpr double slant_z = 15;
  static constexpr double fillet_radius = 8;
  static constexpr double hole_radius = 10;
  static constexpr Vec3 hole_centre{76, 30, 0};
  static constexpr double boss_radius = 12;
  static constexpr double boss_z = 40;
  static constexpr Vec3 boss_centre{40, 30, 0};

  Index add_vertex(const Vec3& p) {
    mesh_.vertices.push_back(p);
    return static_cast<Index>(mesh_.vertices.size() - 1);
  }

  void add(Index a, Index b, Index c) { mesh_.triangles.push_back({a, b, c}); }

  void add_quad(Index a, Index b, Index c, Index d) {
    add(a, b, c);
    add(a, c, d);
  }

  Ring add_circle(const Vec3& centre, double radius, double z) {
    Ring ring;
    for (const auto& [x, y] : unit_circle(circle_points)) {
      ring.push_back(add_vertex({centre.x + radius * x, centre.y + radius * y, z}));
    }
    return ring;
  }

  /// A horizontal rectangle around a circle. Its corners run counterclockwise seen from above, from
  /// the one of largest x and y; each sees the quarter of the circle that faces it.
  void add_plate(const std::array<Index, 4>& corners, const Ring& circle, bool faces_up) {
    const auto add_facing = [&](Index a, Index b, Index c) {
      faces_up ? add(a, b, c) : add(a, c, b);
    };
    for (Index s = 0; s < circle_points; ++s) {
      const Index k = s / quarter;
      const Index next = circle[(s + 1) % circle_points];
      add_facing(corners[k], next, circle[s]);
      if ((s + 1) % quarter == 0) add_facing(corners[k], corners[(k + 1) % 4], next);
    }
  }

  /// A cylinder that faces outward from the lower to the upper circle, inward with the two swapped.
  void add_wall(const Ring& below, const Ring& above) {
    for (Index s = 0; s < circle_points; ++s) {
      const Index next = (s + 1) % circle_points;
      add_quad(below[s], below[next], above[next], above[s]);
    }
  }

  const std::vector<Direction> arc_ = quarter_circle(quarter);
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh part_mesh() { return PartBuilder().build(); }

}  // namespace deburr

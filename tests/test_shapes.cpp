// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <unordered_map>
#include <vector>

#include "box.hpp"
#include "deburr/synth.hpp"
#include "shapes.hpp"
#include "support/compare.hpp"
#include "surface_sampler.hpp"
#include "unit_circle.hpp"

namespace deburr {
namespace {

constexpr double pi = std::numbers::pi;

constexpr std::array<Shape, 8> all_shapes{Shape::Part,       Shape::Cube,       Shape::Sphere,
                                          Shape::Torus,      Shape::Cylinder,   Shape::ThinPlate,
                                          Shape::BumpySheet, Shape::SteppedWall};

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum +=
        norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a])) / 2;
  }
  return sum;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  }
  return sum;
}

double diagonal(const TriangleMesh& mesh) {
  const Box box = bounding_box(mesh);
  return norm(box.high - box.low);
}

/// How many edges of a mesh lie at one triangle only; -1 where two triangles at an edge run the
/// same way, or a vertex is not used.
int boundary_edges(const TriangleMesh& mesh) {
  std::unordered_map<std::uint64_t, int> edges;
  std::vector<bool> used(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      used[t[k]] = true;
      if (++edges[std::uint64_t{t[k]} << 32 | t[(k + 1) % 3]] > 1) return -1;
    }
  }
  if (std::ranges::find(used, false) != used.end()) return -1;
  int open = 0;
  for (const auto& [edge, count] : edges) {
    open += edges.contains(edge << 32 | edge >> 32) ? 0 : 1;
  }
  return open;
}

TEST(ShapeMesh, SolidsAreClosedAndSheetsHaveTheirBoundary) {
  std::vector<int> open;
  for (const Shape shape : all_shapes) open.push_back(boundary_edges(shape_mesh(shape)));
  // The wall has 4 panels of 64 columns with 3 steps between them, and two ends.
  EXPECT_THAT(open, testing::ElementsAre(0, 0, 0, 0, 0, 2 * 4, 4 * 384, 2 * (4 * 64 + 3) + 2));
}

struct Measures {
  Shape shape;
  double area, volume;
};

// Of the true surfaces; chords lose about the square of their angle of it.
TEST(ShapeMesh, SolidsHaveAreaAndVolumeOfTheFormulas) {
  for (const auto& [shape, expected_area, expected_volume] :
       {Measures{Shape::Cube, 6, 1}, Measures{Shape::Sphere, 4 * pi, 4 * pi / 3},
        Measures{Shape::Torus, 4 * pi * pi * 0.4, 2 * pi * pi * 0.16},
        Measures{Shape::Cylinder, 2 * pi * 0.25 + 2 * pi * 0.5 * 1.2, pi * 0.25 * 1.2}}) {
    const TriangleMesh mesh = shape_mesh(shape);
    EXPECT_NEAR(area(mesh), expected_area, 1e-4 * expected_area) << static_cast<int>(shape);
    EXPECT_NEAR(volume(mesh), expected_volume, 1e-4 * expected_volume) << static_cast<int>(shape);
    EXPECT_LE(area(mesh), expected_area * (1 + 1e-12)) << static_cast<int>(shape);
  }
}

/// The height field of the bumpy sheet as docs/synth.md has it.
double height(double x, double y) {
  const auto bump = [&](double cx, double cy, double h, double r) {
    return h / std::pow(1 + (std::pow(x - cx, 2) + std::pow(y - cy, 2)) / (r * r), 2);
  };
  return bump(0.3, 0.35, 0.08, 0.25) + bump(0.7, 0.65, -0.07, 0.22) + bump(0.75, 0.2, 0.04, 0.2) +
         bump(0.2, 0.8, -0.04, 0.2);
}

/// Largest of distance(p) over vertices, and over the middles of triangles and of edges.
template <typename Distance>
std::array<double, 2> deviation(const TriangleMesh& mesh, const Distance& distance) {
  std::array<double, 2> largest{};
  const auto add = [&](std::size_t which, const Vec3& p) {
    largest.at(which) = std::max(largest.at(which), std::abs(distance(p)));
  };
  for (const Vec3& p : mesh.vertices) add(0, p);
  for (const auto& t : mesh.triangles) {
    const std::array<Vec3, 3> p{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    add(1, (1.0 / 3) * (p[0] + p[1] + p[2]));
    for (std::size_t k = 0; k < 3; ++k) add(1, 0.5 * (p.at(k) + p.at((k + 1) % 3)));
  }
  return largest;
}

TEST(ShapeMesh, CurvedShapesStayNearTheSurfacesThatTheyStandFor) {
  const auto expect_near = [](Shape shape, const auto& distance) {
    const TriangleMesh mesh = shape_mesh(shape);
    const auto [at_vertices, between] = deviation(mesh, distance);
    EXPECT_LT(at_vertices, 1e-15) << static_cast<int>(shape);
    EXPECT_LT(between, 1e-5 * diagonal(mesh)) << static_cast<int>(shape);
    EXPECT_GT(between, 1e-6 * diagonal(mesh)) << static_cast<int>(shape);
  };
  expect_near(Shape::Sphere, [](const Vec3& p) { return norm(p) - 1; });
  expect_near(Shape::Torus,
              [](const Vec3& p) { return std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4; });
  expect_near(Shape::Cylinder, [](const Vec3& p) {
    // The ends are flat.
    return std::min(p.z, 1.2 - p.z) < 1e-15 ? std::max(0.0, std::hypot(p.x, p.y) - 0.5)
                                            : std::hypot(p.x, p.y) - 0.5;
  });
  expect_near(Shape::BumpySheet, [](const Vec3& p) { return p.z - height(p.x, p.y); });
}

TEST(ShapeMesh, SheetsFaceTheSideThatTheyStandFor) {
  for (const auto& [a, b, c] : shape_mesh(Shape::BumpySheet).triangles) {
    static const TriangleMesh mesh = shape_mesh(Shape::BumpySheet);
    ASSERT_GT(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]).z, 0);
  }
  const TriangleMesh plate = shape_mesh(Shape::ThinPlate);
  for (std::uint32_t t = 0; t < 4; ++t) {
    const bool upper = plate.vertices[plate.triangles[t][0]].z > 0;
    EXPECT_EQ(triangle_normal(plate, t), (Vec3{0, 0, upper ? 1.0 : -1.0}));
  }
  // Steps rise along x, so that they face back along it.
  const TriangleMesh wall = shape_mesh(Shape::SteppedWall);
  double steps = 0;
  for (std::uint32_t t = 0; t < wall.triangles.size(); ++t) {
    const Vec3 normal = triangle_normal(wall, t);
    if (normal == Vec3{-1, 0, 0}) {
      ++steps;
    } else {
      EXPECT_EQ(normal, (Vec3{0, 0, 1}));
    }
  }
  EXPECT_EQ(steps, 3 * 2);
  EXPECT_NEAR(area(wall), 4 + 0.35, 1e-12);
}

TEST(ShapeMesh, ThicknessIsAFractionOfTheDiagonal) {
  for (const double thickness : {1e-6, 0.01, 0.5, 0.99}) {
    const TriangleMesh mesh = shape_mesh(Shape::ThinPlate, {.thickness = thickness});
    const Box box = bounding_box(mesh);
    EXPECT_EQ(box.high.x, 1);
    EXPECT_NEAR((box.high.z - box.low.z) / diagonal(mesh), thickness, 1e-12 * thickness);
    EXPECT_EQ(area(mesh), 2);
  }
}

TEST(ShapeMesh, NamesTheWrongThickness) {
  for (const double wrong : {0.0, 1.0, -0.1, std::nan("")}) {
    EXPECT_THAT(
        invalid_argument_of([&] { (void)shape_mesh(Shape::ThinPlate, {.thickness = wrong}); }),
        testing::StartsWith("shape.thickness must be in (0, 1), got "))
        << wrong;
  }
}

TEST(SteppedWall, IsTenTimesAsDenseAtOneEnd) {
  const SampledShape wall = stepped_wall();
  ASSERT_EQ(wall.density.size(), wall.mesh.triangles.size());
  EXPECT_NEAR(wall.density.front() / wall.density.back(), 10, 0.15);
  EXPECT_TRUE(std::ranges::is_sorted(wall.density, std::ranges::greater()));
  // From one column to the next the density hardly changes.
  for (std::size_t t = 1; t < wall.density.size(); ++t) {
    EXPECT_GT(wall.density[t], 0.98 * wall.density[t - 1]);
  }
}

TEST(UnitCircle, HasEqualAnglesToTheLastBits) {
  for (const std::size_t count : {std::size_t{4}, std::size_t{8}, std::size_t{512}}) {
    const std::vector<Direction> circle = unit_circle(count);
    ASSERT_EQ(circle.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(count);
      EXPECT_NEAR(circle[i].cos, std::cos(angle), 1e-15);
      EXPECT_NEAR(circle[i].sin, std::sin(angle), 1e-15);
    }
  }
}

}  // namespace
}  // namespace deburr

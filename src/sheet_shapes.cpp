// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "part_mesh.hpp"
#include "require.hpp"
#include "shapes.hpp"

namespace deburr {
namespace {

// Fine enough for chords within 1e-5 of the diagonal of the bounding box.
constexpr std::size_t bumpy_steps = 384;

/// A smooth hill, or a hollow, of a height field.
struct Bump {
  double x, y;
  double height;
  double radius;  ///< where a quarter of the height is left
};
constexpr std::array<Bump, 4> bumps{{{0.3, 0.35, 0.08, 0.25},
                                     {0.7, 0.65, -0.07, 0.22},
                                     {0.75, 0.2, 0.04, 0.2},
                                     {0.2, 0.8, -0.04, 0.2}}};

double bumpy_height(double x, double y) {
  double z = 0;
  for (const Bump& bump : bumps) {
    const double dx = (x - bump.x) / bump.radius;
    const double dy = (y - bump.y) / bump.radius;
    const double q = 1 + dx * dx + dy * dy;
    z += bump.height / (q * q);
  }
  return z;
}

// The wall runs along x, stands up along y and faces z.
constexpr std::size_t panel_steps = 64;
constexpr std::array<double, 4> panel_z{0, 0.05, 0.15, 0.35};
constexpr double fall_off = 10;

}  // namespace

TriangleMesh thin_plate_mesh(double thickness) {
  // The diagonal of 1 x 1 x gap is gap / thickness.
  const double gap = thickness * std::sqrt(2 / (1 - thickness * thickness));
  TriangleMesh mesh;
  add_grid(mesh, 1, 1, false, false, [&](std::size_t i, std::size_t j) {
    return Vec3{static_cast<double>(i), static_cast<double>(j), gap};
  });
  add_grid(mesh, 1, 1, false, false, [&](std::size_t i, std::size_t j) {
    return Vec3{static_cast<double>(j), static_cast<double>(i), 0};
  });
  return mesh;
}

TriangleMesh bumpy_sheet_mesh() {
  TriangleMesh mesh;
  add_grid(mesh, bumpy_steps, bumpy_steps, false, false, [&](std::size_t i, std::size_t j) {
    const double x = static_cast<double>(i) / bumpy_steps;
    const double y = static_cast<double>(j) / bumpy_steps;
    return Vec3{x, y, bumpy_height(x, y)};
  });
  return mesh;
}

SampledShape stepped_wall() {
  SampledShape wall;
  // Columns from left to right; two at one x are the foot and the head of a step.
  std::vector<Vec3> outline;
  for (std::size_t panel = 0; panel < panel_z.size(); ++panel) {
    for (std::size_t i = 0; i <= panel_steps; ++i) {
      const double along = static_cast<double>(i) / panel_steps;
      outline.push_back({static_cast<double>(panel) + along, 0, panel_z.at(panel)});
    }
  }
  add_grid(wall.mesh, outline.size() - 1, 1, false, false, [&](std::size_t i, std::size_t j) {
    return outline[i] + static_cast<double>(j) * Vec3{0, 1, 0};
  });
  // As from a scanner beyond the dense end: with the inverse square of the distance.
  const double rate = (std::sqrt(fall_off) - 1) / static_cast<double>(panel_z.size());
  for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
    const double distance = 1 + rate * 0.5 * (outline[i].x + outline[i + 1].x);
    wall.density.insert(wall.density.end(), 2, 1 / (distance * distance));
  }
  return wall;
}

SampledShape sampled_shape(Shape shape, const ShapeOptions& options) {
  require(options.thickness > 0 && options.thickness < 1, "shape.thickness", "in (0, 1)",
          options.thickness);
  switch (shape) {
    case Shape::Part:
      return {part_mesh(), {}};
    case Shape::Cube:
      return {cube_mesh(), {}};
    case Shape::Sphere:
      return {sphere_mesh(), {}};
    case Shape::Torus:
      return {torus_mesh(), {}};
    case Shape::Cylinder:
      return {cylinder_mesh(), {}};
    case Shape::ThinPlate:
      return {thin_plate_mesh(options.thickness), {}};
    case Shape::BumpySheet:
      return {bumpy_sheet_mesh(), {}};
    case Shape::SteppedWall:
      return stepped_wall();
  }
  throw std::invalid_argument(
      fmt::format("shape must be a Shape, got {}", static_cast<int>(shape)));
}

TriangleMesh shape_mesh(Shape shape, const ShapeOptions& options) {
  return sampled_shape(shape, options).mesh;
}

}  // namespace deburr

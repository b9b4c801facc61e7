// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <vector>

#include "deburr/position_update.hpp"
#include "support/compare.hpp"
#include "support/feature_field.hpp"
#include "support/shapes.hpp"

// How far a position update may go, and where it has nothing to go by.

namespace deburr {
namespace {

constexpr Vec3 up{0, 0, 1};
constexpr double far = 1e9;  // a bound that is never met

/// A point at height 1 over four in the plane z = 0, which it would reach in one step.
struct OverPlane {
  std::vector<Vec3> points{{0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  std::vector<Vec3> original = points;
  PositionUpdateOptions options{.position_scale = 1, .step = 1, .max_move = far};

  [[nodiscard]] Vec3 moved() const {
    return update_positions(original, points, std::vector<Vec3>(5, up), all(Feature::Surface, 5),
                            find_neighbors(points, {.max_count = 4}), options)[0];
  }
};

TEST(PositionLimits, MovesAlongTheNormalByTheStep) {
  OverPlane over;
  EXPECT_LE(norm(over.moved()), 1e-15);
  over.options.step = 0.25;
  EXPECT_LE(norm(over.moved() - Vec3{0, 0, 0.75}), 1e-15);
}

TEST(PositionLimits, ClampsAtTheBoundFromTheOriginal) {
  OverPlane over;
  over.options.bound = Bound::Clamp;
  over.options.max_move = 0.4;
  EXPECT_LE(norm(over.moved() - Vec3{0, 0, 0.6}), 1e-15);
  over.original[0] = {0, 0, 1.2};
  EXPECT_LE(norm(over.moved() - Vec3{0, 0, 0.8}), 1e-15);
  over.original[0] = {0, 0.3, 0.4};  // 0.5 from the origin: four fifths of the way to it
  EXPECT_LE(norm(over.moved() - Vec3{0, 0.06, 0.08}), 1e-15);
}

TEST(PositionLimits, StaysAtTheOriginalWithABoundOfZero) {
  for (const Bound bound : {Bound::Clamp, Bound::Reject}) {
    OverPlane over;
    over.options.bound = bound;
    over.options.max_move = 0;
    EXPECT_EQ(over.moved(), over.points[0]);
    over.points[0].z = over.original[0].z = 0;  // no move at all
    EXPECT_EQ(over.moved(), over.points[0]);
  }
}

TEST(PositionLimits, RejectsAMoveBeyondTheBound) {
  OverPlane over;
  over.options.bound = Bound::Reject;
  over.options.max_move = 1 + 1e-9;
  EXPECT_LE(norm(over.moved()), 1e-15);
  over.options.max_move = 1 - 1e-9;
  EXPECT_EQ(over.moved(), over.points[0]);
  over.options.max_move = 1.5;
  over.original[0] = {0, 0, 2};
  EXPECT_EQ(over.moved(), over.points[0]);
}

TEST(PositionLimits, StaysFiniteWhereTheQuadricIsSingular) {
  PositionUpdateOptions options{.position_scale = 1, .feature_step = 1, .max_move = 0.5};
  const std::vector<Vec3> plane = plane_grid(5).points;
  std::vector<Vec3> line(25);
  for (std::size_t i = 0; i < line.size(); ++i) line[i].x = static_cast<double>(i);
  const std::vector<Vec3> distant(25, Vec3{1, 2, 3});
  for (const std::vector<Vec3>& points : {plane, line, distant}) {
    const Neighborhoods near = find_neighbors(points, {.max_count = 8});
    for (const Vec3& normal : {up, Vec3{1, 0, 0}, Vec3{}}) {
      const std::vector<Vec3> normals(points.size(), normal);
      for (const Feature label : {Feature::Surface, Feature::Edge, Feature::Corner}) {
        for (const Quadric quadric : {Quadric::Guarded, Quadric::Plain}) {
          options.quadric = quadric;
          const FeatureField field = all(label, points.size(), {1, 0, 0});
          const auto moved = update_positions(points, points, normals, field, near, options);
          EXPECT_LE(max_difference(moved, points), 0.5);
        }
      }
    }
  }
}

// Coplanar neighbours say nothing of the directions within their plane; what they say of the
// height still counts.
TEST(PositionLimits, GuardedQuadricReachesThePlaneOfCoplanarNeighbors) {
  const OverPlane over;
  PositionUpdateOptions options = over.options;
  options.feature_step = 1;
  for (const Feature label : {Feature::Edge, Feature::Corner}) {
    const Vec3 along = label == Feature::Edge ? Vec3{1, 0, 0} : Vec3{};
    const Vec3 moved =
        update_positions(over.original, over.points, std::vector<Vec3>(5, up), all(label, 5, along),
                         find_neighbors(over.points, {.max_count = 4}), options)[0];
    EXPECT_LE(norm(moved), 0.1);
  }
}

// The guarded quadric of coplanar neighbours must not slide a point within their plane.
TEST(PositionLimits, GuardedQuadricStaysInItsPlane) {
  const Sampled plane = plane_grid(7);
  const auto moved = update_positions(
      plane.points, plane.points, plane.normals, all(Feature::Corner, plane.points.size()),
      find_neighbors(plane.points, {.max_count = 8}), {.position_scale = 1, .max_move = far});
  EXPECT_LE(max_difference(moved, plane.points), 1e-15);
}

TEST(PositionLimits, LeavesPointsWithoutNeighborsAndIsolatedOnesAlone) {
  const std::vector<Vec3> points = random_points(20, 4);
  const std::vector<Vec3> normals = random_directions(20, 5);
  const PositionUpdateOptions options{.position_scale = 1, .max_move = far};
  const Neighborhoods near = find_neighbors(points, {.max_count = 5});
  EXPECT_EQ(update_positions(points, points, normals, all(Feature::Isolated, 20), near, options),
            points);
  const Neighborhoods none = find_neighbors(points, {.radius = 1e-9});
  for (const Feature label : {Feature::Surface, Feature::Edge, Feature::Corner}) {
    EXPECT_EQ(update_positions(points, points, normals, all(label, 20), none, options), points);
  }
  // Neighbours whose weights vanish say nothing either.
  const PositionUpdateOptions narrow{.position_scale = 1e-9, .max_move = far};
  EXPECT_EQ(update_positions(points, points, normals, all(Feature::Surface, 20), near, narrow),
            points);
}

}  // namespace
}  // namespace deburr

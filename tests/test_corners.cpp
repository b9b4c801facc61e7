// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "corners.hpp"

namespace deburr {
namespace {

constexpr Vec3 x_axis{1, 0, 0};
constexpr Vec3 y_axis{0, 1, 0};
constexpr Vec3 z_axis{0, 0, 1};

/// Points of edges, each with the sheets through it that it knows of.
struct Edges {
  std::vector<Vec3> places;
  std::vector<EdgePoint> points;

  void add(const Vec3& place, const std::vector<Vec3>& normals) {
    EdgePoint point{static_cast<std::uint32_t>(places.size()), {}, normals.size()};
    for (std::size_t k = 0; k < normals.size(); ++k) {
      point.sheets.at(k) = {place, normals[k]};
    }
    places.push_back(place);
    points.push_back(point);
  }
  /// From 0 to 6 along a direction, four for each spacing.
  void add_edge(const Vec3& along, const std::vector<Vec3>& normals) {
    for (int i = 0; i <= 24; ++i) add((0.25 * i) * along, normals);
  }
  [[nodiscard]] std::vector<Feature> labels(double unit = 1, int threads = 1) const {
    std::vector<Vec3> scaled;
    for (const Vec3& p : places) scaled.push_back(unit * p);
    std::vector<EdgePoint> edges = points;
    for (EdgePoint& edge : edges) {
      for (CutSheet& sheet : edge.sheets) sheet.foot = unit * sheet.foot;
    }
    std::vector<Feature> labels(places.size(), Feature::Edge);
    label_corners(edges, scaled, unit, labels, {.threads = threads});
    return labels;
  }
  [[nodiscard]] std::size_t corners() const {
    std::size_t count = 0;
    for (const Feature label : labels()) count += label == Feature::Corner ? 1 : 0;
    return count;
  }
};

/// Three edges between the faces across the axes, of each of which a point knows two faces.
Edges three_faces() {
  Edges edges;
  edges.add_edge(-x_axis, {y_axis, z_axis});
  edges.add_edge(-y_axis, {x_axis, z_axis});
  edges.add_edge(-z_axis, {x_axis, y_axis});
  return edges;
}

TEST(Corners, AreWhereThreeFacesMeet) {
  const Edges edges = three_faces();
  const std::vector<Feature> labels = edges.labels();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double distance = norm(edges.places[i]);
    EXPECT_EQ(labels[i], distance < 1.4 ? Feature::Corner : Feature::Edge) << distance;
  }
}

TEST(Corners, AreTheSameInAnyUnitAndForAnyThreads) {
  const Edges edges = three_faces();
  const std::vector<Feature> labels = edges.labels();
  for (const double unit : {0x1p-30, 1e-6, 1e6}) EXPECT_EQ(edges.labels(unit), labels) << unit;
  EXPECT_EQ(edges.labels(1, 5), labels);
}

TEST(Corners, NeedMoreThanOnePointThatKnowsOfAThirdSheet) {
  Edges edges;
  for (int i = 0; i < 12; ++i) edges.add({0.5 * i, 0, 0}, {y_axis, z_axis});
  EXPECT_EQ(edges.corners(), 0U);
  edges.add({0.1, 0, 0}, {x_axis, y_axis, z_axis});
  EXPECT_EQ(edges.corners(), 0U);
  edges.add({0.2, 0, 0}, {x_axis, y_axis, z_axis});
  EXPECT_EQ(edges.corners(), 0U);
  // Three may be right.
  edges.add({0.15, 0, 0}, {x_axis, y_axis, z_axis});
  EXPECT_GT(edges.corners(), 3U);
}

// Three points agree on a sheet if their normals are within 25 degrees.
TEST(Corners, AreOfSheetsWithNormalsThatAgree) {
  for (const bool agree : {true, false}) {
    const double s = agree ? 0.25 : 0.7;
    const double c = std::sqrt(1 - s * s);
    Edges edges;
    for (int i = 0; i < 12; ++i) edges.add({0.5 * i, 0, 0}, {y_axis, z_axis});
    edges.add({0, 0, 0}, {{c, s, 0}});
    edges.add({0, 0, 0}, {x_axis});
    edges.add({0, 0, 0}, {{c, -s, 0}});
    EXPECT_EQ(edges.corners() > 0, agree);
  }
}

// Of many points around, three are no fifth.
TEST(Corners, NeedAFifthOfThePointsAround) {
  Edges edges;
  for (int i = 0; i < 4; ++i) edges.add_edge(x_axis, {y_axis, z_axis});
  for (int i = 0; i < 3; ++i) edges.add({0.1 + 0.01 * i, 0, 0}, {x_axis, y_axis, z_axis});
  EXPECT_EQ(edges.corners(), 0U);
}

// The rim of a thin plate: its two sheets are parallel.
TEST(Corners, AreNoneOfParallelSheets) {
  Edges edges;
  edges.add_edge(x_axis, {y_axis, z_axis});
  edges.add_edge(x_axis, {y_axis, -z_axis});
  EXPECT_EQ(edges.corners(), 0U);
}

// One sheet that bends is no two.
TEST(Corners, NeedSheetsThirtyDegreesApart) {
  for (const double degrees : {20.0, 28.0, 45.0}) {
    const double turn = degrees / 57.29577951308232;
    const Vec3 third{std::sin(turn), 0, std::cos(turn)};
    Edges edges;
    edges.add_edge(x_axis, {y_axis, z_axis});
    edges.add_edge(-x_axis, {y_axis, third});
    EXPECT_EQ(edges.corners() > 0, degrees > 30) << degrees;
  }
}

// Their planes meet, but five spacings away.
TEST(Corners, AreNearThePointsThatKnowOfThem) {
  Edges edges;
  for (int i = 0; i < 12; ++i) edges.add({0.1 * i, 0, 0}, {y_axis, z_axis});
  for (EdgePoint& edge : edges.points) {
    edge.sheets[2] = {Vec3{5, 0, 0}, x_axis};
    edge.count = 3;
  }
  EXPECT_EQ(edges.corners(), 0U);
}

TEST(Corners, AreNoneWithoutEdges) {
  std::vector<Feature> labels(3, Feature::Surface);
  const std::vector<Vec3> places(3);
  label_corners({}, places, 1, labels, {});
  EXPECT_EQ(labels, std::vector<Feature>(3, Feature::Surface));
}

}  // namespace
}  // namespace deburr

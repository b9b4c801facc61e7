// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deburr/feature_metrics.hpp"
#include "support/compare.hpp"
#include "support/meshes.hpp"
#include "support/triangle_oracle.hpp"

namespace deburr {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const SharpFeatures& cube_features() {
  static const SharpFeatures features = find_sharp_features(cube_mesh());
  return features;
}

// On the cube [0, 1]^3 with a spacing of 0.1: labels count up to 0.15 from an edge and 0.2 from a
// corner, points up to 0.05 from an edge are of the edge, all of it near that along x.
TEST(ScoreFeatures, IsThatDerivedByHandOnACube) {
  const std::vector<Vec3> points{
      {0.5, 0.14, 0},   // edge, right: sees x from 0.446 to 0.554
      {0.5, 0.16, 0},   // edge, wrong
      {0.5, 0.04, 0},   // surface, of the edge
      {0.3, 0, 0},      // edge, right, of the edge: sees 0.15 to 0.45
      {0.19, 0, 0},     // corner, right for both, of the edge: sees 0.04 to 0.34
      {0.5, 0.5, 0},    // corner, wrong
      {nan, 0, 0},      // edge
      {0.5, 0.5, 1},    // isolated
      {0.5, 0.06, 0.0}  // surface, not of the edge
  };
  using enum Feature;
  const std::vector<Feature> labels{Edge,   Edge, Surface,  Edge,   Corner,
                                    Corner, Edge, Isolated, Surface};
  const FeatureScore score = score_features(points, labels, cube_features(), 0.1);
  EXPECT_EQ(score.edge_labels, 5U);
  EXPECT_EQ(score.corner_labels, 2U);
  EXPECT_DOUBLE_EQ(score.edge_precision, 3.0 / 5);
  EXPECT_DOUBLE_EQ(score.edge_point_recall, 2.0 / 3);
  // Of 40 pieces of each of 12 edges, those with their middles at 0.0625 to 0.5375.
  EXPECT_DOUBLE_EQ(score.edge_recall, 20.0 / 40 / 12);
  EXPECT_DOUBLE_EQ(score.corner_precision, 1.0 / 2);
  EXPECT_DOUBLE_EQ(score.corner_recall, 1.0 / 8);
}

TEST(ScoreFeatures, IsHighForTrueLabels) {
  const Sampled sampled = cube(20000, 1);
  const std::vector<Vec3> points = mapped(sampled.points, [](const Vec3& p) {
    return 0.5 * (p + Vec3{1, 1, 1});
  });
  const double spacing = mean_spacing(cube_mesh(), points.size());
  std::vector<Feature> labels;
  for (const Vec3& p : points) {
    double to_side[3] = {std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y), std::min(p.z, 1 - p.z)};
    std::ranges::sort(to_side);
    labels.push_back(to_side[2] < 1.4 * spacing   ? Feature::Corner
                     : to_side[1] < 1.4 * spacing ? Feature::Edge
                                                  : Feature::Surface);
  }
  const FeatureScore score = score_features(points, labels, cube_features(), spacing);
  EXPECT_EQ(score.edge_precision, 1);
  EXPECT_GT(score.edge_recall, 0.995);  // random points leave a gap now and then
  EXPECT_EQ(score.edge_point_recall, 1);
  EXPECT_EQ(score.corner_precision, 1);
  EXPECT_EQ(score.corner_recall, 1);
}

TEST(ScoreFeatures, EqualsBruteForceAtRandom) {
  const SharpFeatures sharp = find_sharp_features(prism_mesh(5));
  std::vector<Vec3> points;
  for (const Vec3& p : random_points(120, 2)) {
    const auto& [a, b] = sharp.edges[static_cast<std::size_t>(p.x * 15)];
    points.push_back(a + p.y * (b - a) + Vec3{0.15 * p.z, 0.08 * p.y, -0.1 * p.z});
  }
  std::vector<Feature> labels;
  for (const Vec3& p : random_points(120, 3)) labels.push_back(static_cast<Feature>(4 * p.x));
  const double spacing = 0.07;
  const auto marked = [&](std::size_t i) {
    return labels[i] == Feature::Edge || labels[i] == Feature::Corner;
  };
  double right = 0;
  double all = 0;
  double zone = 0;
  double zone_marked = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double d = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : sharp.edges) {
      d = std::min(d, static_cast<double>(oracle::distance(points[i], {a, b, b})));
    }
    if (marked(i)) ++all;
    if (marked(i) && d <= 1.5 * spacing) ++right;
    if (d <= 0.5 * spacing) ++zone;
    if (marked(i) && d <= 0.5 * spacing) ++zone_marked;
  }
  // A much finer step than the library's: they differ by the pieces at the ends of what is seen.
  double length = 0;
  double seen = 0;
  for (const auto& [a, b] : sharp.edges) {
    for (int k = 0; k < 2000; ++k) {
      const Vec3 at = a + ((k + 0.5) / 2000) * (b - a);
      length += norm(b - a);
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (marked(i) && norm(points[i] - at) <= 1.5 * spacing) {
          seen += norm(b - a);
          break;
        }
      }
    }
  }
  const FeatureScore score = score_features(points, labels, sharp, spacing);
  ASSERT_GT(right, 10);
  ASSERT_GT(zone_marked, 5);
  EXPECT_DOUBLE_EQ(score.edge_precision, right / all);
  EXPECT_DOUBLE_EQ(score.edge_point_recall, zone_marked / zone);
  EXPECT_NEAR(score.edge_recall, seen / length, 0.02);
  EXPECT_GT(score.edge_recall, 0.1);
  EXPECT_LT(score.edge_recall, 0.9);
}

TEST(ScoreFeatures, IsNanWhereThereIsNothingToTakeAShareOf) {
  const std::vector<Vec3> points{{0.5, 0.5, 0}};
  const std::vector<Feature> surface{Feature::Surface};
  const FeatureScore none = score_features(points, surface, cube_features(), 0.1);
  EXPECT_TRUE(std::isnan(none.edge_precision));
  EXPECT_TRUE(std::isnan(none.edge_point_recall));
  EXPECT_TRUE(std::isnan(none.corner_precision));
  EXPECT_EQ(none.edge_recall, 0);
  EXPECT_EQ(none.corner_recall, 0);
  const std::vector<Feature> edge{Feature::Edge};
  const FeatureScore smooth = score_features(points, edge, {}, 0.1);
  EXPECT_EQ(smooth.edge_precision, 0);
  EXPECT_TRUE(std::isnan(smooth.edge_recall));
  EXPECT_TRUE(std::isnan(smooth.corner_recall));
}

TEST(ScoreFeatures, RefusesWhatMakesNoSense) {
  const std::vector<Vec3> points{{0.5, 0.5, 0}};
  const std::vector<Feature> labels{Feature::Edge};
  EXPECT_EQ(invalid_argument_of([&] { (void)score_features(points, {}, cube_features(), 0.1); }),
            "labels must have one entry per point (1), got 0");
  for (const double spacing : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_NE(invalid_argument_of(
                  [&] { (void)score_features(points, labels, cube_features(), spacing); }),
              "");
    EXPECT_NE(invalid_argument_of(
                  [&] { (void)edge_error(points, cube_mesh(), cube_features(), spacing); }),
              "");
  }
}

TEST(ScoreFeatures, IsTheSameForAnyNumberOfThreadsAndNeverGoesBack) {
  const std::vector<Vec3> points = random_points(5000, 5);
  const std::vector<Feature> labels(points.size(), Feature::Edge);
  double last = 0;
  const Execution watched{.threads = 3, .progress = [&](const Progress& p) {
                            EXPECT_GE(p.fraction, last);
                            last = p.fraction;
                          }};
  const FeatureScore one = score_features(points, labels, cube_features(), 0.03, {.threads = 1});
  const FeatureScore three = score_features(points, labels, cube_features(), 0.03, watched);
  EXPECT_EQ(one.edge_recall, three.edge_recall);
  EXPECT_EQ(one.edge_precision, three.edge_precision);
  EXPECT_EQ(last, 1);
}

TEST(EdgeError, IsThatOfThePointsNearEdges) {
  const std::vector<Vec3> points{{0.5, 0.06, -0.03},  // 0.067 from the edge
                                 {0.5, -0.05, 0.5},   // off a face, far from edges
                                 {1.03, 1.04, 0.5},   // beyond an edge, 0.05 from it
                                 {0.5, 0.09, -0.06},  // 0.108 from the edge
                                 {nan, 0, 0}};
  const DistanceError error = edge_error(points, cube_mesh(), cube_features(), 0.1);
  EXPECT_EQ(error.count, 2U);
  EXPECT_NEAR(error.mean, (0.03 + 0.05) / 2, 1e-15);
  EXPECT_EQ(edge_error(points, cube_mesh(), {}, 0.1).count, 0U);
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <array>

#include "deburr/features.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"
#include "support/stage_oracle.hpp"

namespace deburr {
namespace {

using testing::Each;
using testing::IsEmpty;

constexpr Vec3 up{0, 0, 1};

TEST(ClassifyFeatures, EqualsTheOracle) {
  const std::vector<Vec3> points = random_points(500, 1);
  const Neighborhoods near = find_neighbors(points, {.radius = 0.2});
  std::vector<Vec3> normals = tilted(std::vector<Vec3>(500, up), 1.0, 2);
  for (std::size_t i = 0; i < normals.size(); i += 17) normals[i] = {};
  std::array<int, 4> seen{};
  for (const double rho : {0.1, 0.6, 0.9, 0.99}) {
    const FeatureField field = classify_features(points, normals, near, {.rho = rho});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const oracle::Class c = oracle::classify(points, normals, i, near[i], {.rho = rho});
      ASSERT_EQ(field.label[i], c.label) << i;
      ASSERT_LE(
          std::min(norm(field.direction[i] - c.direction), norm(field.direction[i] + c.direction)),
          1e-8);
      ++seen.at(static_cast<std::size_t>(c.label));
    }
  }
  EXPECT_THAT(seen, Each(testing::Gt(50)));
}

TEST(ClassifyFeatures, FindsSurfaceOnTheFacesOfACube) {
  const Sampled truth = cube_grid(12);
  const FeatureField field =
      classify_features(truth.points, truth.normals, find_neighbors(truth.points, {.radius = 0.5}));
  EXPECT_THAT(field.label, Each(Feature::Surface));
  EXPECT_THAT(field.direction, Each(Vec3{}));
}

// Like the points of a rounded edge: a strip of equal normals, far longer than wide.
TEST(ClassifyFeatures, FindsAnEdgeAlongAStripOfEqualNormals) {
  const Rotation turn = random_rotation(3);
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  for (int along = 0; along < 21; ++along) {
    for (int across = -3; across <= 3; ++across) {
      points.push_back(turn(Vec3{1.0 * along, 0.5 * across, -0.2 * across * across}));
      normals.push_back(turn(Vec3{0, std::sin(0.5 * across), std::cos(0.5 * across)}));
    }
  }
  const FeatureField field =
      classify_features(points, normals, find_neighbors(points, {.radius = 4}));
  EXPECT_THAT(field.label, Each(Feature::Edge));
  for (const Vec3& d : field.direction) EXPECT_LT(norm(cross(d, turn({1, 0, 0}))), 1e-12);
}

TEST(ClassifyFeatures, FindsACornerWhereNoDirectionIsMissing) {
  const std::vector<Vec3> points{{}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, up, -up};
  const FeatureField field =
      classify_features(points, std::vector<Vec3>(7, up), find_neighbors(points, {.max_count = 6}));
  EXPECT_EQ(field.label[0], Feature::Corner);
  EXPECT_EQ(field.direction[0], Vec3{});
}

TEST(ClassifyFeatures, CountsOnlySimilarNormals) {
  // A line of the same normals among a plane of others.
  Sampled plane = plane_grid(9);
  for (std::size_t i = 0; i < plane.points.size(); ++i) {
    if (plane.points[i].y == 4) plane.normals[i] = {0, 0.6, 0.8};
  }
  const FeatureField field =
      classify_features(plane.points, plane.normals, find_neighbors(plane.points, {.radius = 3}));
  for (std::size_t i = 0; i < plane.points.size(); ++i) {
    EXPECT_EQ(field.label[i], plane.points[i].y == 4 ? Feature::Edge : Feature::Surface) << i;
  }
}

TEST(ClassifyFeatures, DoesNotDependOnTheUnit) {
  const std::vector<Vec3> points = random_points(300, 4);
  const std::vector<Vec3> normals = tilted(std::vector<Vec3>(300, up), 0.5, 5);
  const Neighborhoods near = find_neighbors(points, {.max_count = 20});
  const FeatureField field = classify_features(points, normals, near);
  for (const double unit : {0x1p-100, 0x1p+100}) {
    const auto scaled = mapped(points, [&](const Vec3& p) { return unit * p; });
    EXPECT_EQ(classify_features(scaled, normals, near).label, field.label);
  }
}

TEST(ClassifyFeatures, IsolatesWhatHasNothingToCompareWith) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}};
  const Neighborhoods both = find_neighbors(points, {.max_count = 1});
  const auto first = [&](const Vec3& a, const Vec3& b, const Neighborhoods& near) {
    return classify_features(points, std::vector<Vec3>{a, b}, near).label[0];
  };
  EXPECT_EQ(first(up, up, both), Feature::Edge);
  EXPECT_EQ(first(up, -up, both), Feature::Isolated);
  EXPECT_EQ(first(up, {}, both), Feature::Isolated);
  EXPECT_EQ(first({}, up, both), Feature::Isolated);
  EXPECT_EQ(first(up, up, find_neighbors(points, {.radius = 0.5})), Feature::Isolated);
  const std::vector<Vec3> same(4, Vec3{0.1, 0.2, 0.3});
  EXPECT_THAT(
      classify_features(same, std::vector<Vec3>(4, up), find_neighbors(same, {.max_count = 3}))
          .label,
      Each(Feature::Isolated));
  EXPECT_THAT(classify_features({}, {}, {}).label, IsEmpty());
}

TEST(ClassifyFeatures, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Vec3> points = random_points(4000, 6);
  const std::vector<Vec3> normals = tilted(std::vector<Vec3>(4000, up), 0.4, 7);
  const Neighborhoods near = find_neighbors(points, {.max_count = 20});
  const FeatureField one = classify_features(points, normals, near, {}, {.threads = 1});
  for (const int threads : {2, 3, 7}) {
    const FeatureField other = classify_features(points, normals, near, {}, {.threads = threads});
    EXPECT_EQ(other.label, one.label);
    EXPECT_EQ(other.direction, one.direction);
  }
}

TEST(ClassifyFeatures, NamesTheWrongOption) {
  const auto error = [](const FeatureOptions& options) {
    return invalid_argument_of([&] { (void)classify_features({}, {}, {}, options); });
  };
  EXPECT_EQ(error({.rho = 1}), "features.rho must be in [0, 1), got 1");
  EXPECT_EQ(error({.tau = 0}), "features.tau must be in (0, 1), got 0");
  EXPECT_EQ(error({.tau = std::nan("")}), "features.tau must be in (0, 1), got nan");
  const std::vector<Vec3> two(2);
  EXPECT_EQ(invalid_argument_of([&] { (void)classify_features(two, {}, {}); }),
            "normals must have one entry per point (2), got 0");
  EXPECT_EQ(invalid_argument_of([&] { (void)classify_features(two, two, {}); }),
            "neighborhoods must have one entry per point (2), got 0");
}

TEST(Feature, HasAName) {
  EXPECT_EQ(to_string(Feature::Surface), "surface");
  EXPECT_EQ(to_string(Feature::Edge), "edge");
  EXPECT_EQ(to_string(Feature::Corner), "corner");
  EXPECT_EQ(to_string(Feature::Isolated), "isolated");
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "deburr/position_update.hpp"
#include "support/compare.hpp"
#include "support/feature_field.hpp"
#include "support/shapes.hpp"
#include "support/stage_oracle.hpp"

namespace deburr {
namespace {

constexpr Vec3 up{0, 0, 1};
constexpr double far = 1e9;  // a bound that is never met

void expect_equals_oracle(const PositionUpdateOptions& options) {
  const std::vector<Vec3> points = random_points(300, 1);
  const std::vector<Vec3> normals = tilted(std::vector<Vec3>(300, up), 0.6, 2);
  const Neighborhoods near = find_neighbors(points, {.radius = 0.25});
  FeatureField field = classify_features(points, normals, near, {.rho = 0.8});
  const std::vector<Vec3> moved = update_positions(points, points, normals, field, near, options);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (field.label[i] == Feature::Isolated) {
      EXPECT_EQ(moved[i], points[i]);
    } else {
      const Vec3 expected = oracle::unbounded(points, normals, i, near[i],
                                              {field.label[i], field.direction[i]}, options);
      EXPECT_LE(norm(moved[i] - expected), 1e-10) << to_string(field.label[i]) << " " << i;
    }
  }
  for (const Feature label : {Feature::Surface, Feature::Edge, Feature::Corner}) {
    EXPECT_THAT(field.label, testing::Contains(label).Times(testing::Gt(10)));
  }
}

TEST(UpdatePositions, EqualsTheOracle) {
  for (const Offset offset : {Offset::Projected, Offset::Symmetric}) {
    expect_equals_oracle({.position_scale = 0.1,
                          .normal_scale = 0.4,
                          .max_move = far,
                          .offset = offset,
                          .quadric = Quadric::Plain});
    expect_equals_oracle({.position_scale = 0.2,
                          .normal_scale = 2,
                          .step = 1,
                          .feature_step = 1,
                          .max_move = far,
                          .offset = offset,
                          .quadric = Quadric::Plain});
  }
}

TEST(UpdatePositions, MovesAnEdgePointOntoTheEdgeOfTwoPlanes) {
  // The planes x = 0 and y = 0 meet in the z axis.
  std::vector<Vec3> points{{0.3, 0.2, 0.1}};
  std::vector<Vec3> normals{{std::sqrt(0.5), std::sqrt(0.5), 0}};
  for (int k = -2; k <= 2; ++k) {
    points.push_back({0, -0.5, 0.3 * k});
    normals.push_back({1, 0, 0});
    points.push_back({-0.5, 0, 0.3 * k});
    normals.push_back({0, 1, 0});
  }
  const Neighborhoods near = find_neighbors(points, {.max_count = 10});
  const FeatureField edge = all(Feature::Edge, points.size(), {0, 0, 1});
  PositionUpdateOptions options{
      .position_scale = 1, .feature_step = 1, .max_move = far, .quadric = Quadric::Plain};
  // The first point is a neighbour of the others, but not of itself.
  const Vec3 on_edge = update_positions(points, points, normals, edge, near, options)[0];
  EXPECT_LE(norm(on_edge - Vec3{0, 0, 0.1}), 1e-14);
  options.feature_step = 0.5;
  const Vec3 half = update_positions(points, points, normals, edge, near, options)[0];
  EXPECT_LE(norm(half - Vec3{0.15, 0.1, 0.1}), 1e-14);
  options.quadric = Quadric::Guarded;
  options.feature_step = 1;
  const Vec3 guarded = update_positions(points, points, normals, edge, near, options)[0];
  EXPECT_LE(norm(guarded - Vec3{0, 0, 0.1}), 0.1 * norm(Vec3{0.3, 0.2, 0}));
  EXPECT_NEAR(guarded.z, 0.1, 1e-14);
}

TEST(UpdatePositions, MovesACornerPointIntoTheCornerOfThreePlanes) {
  std::vector<Vec3> points{{0.3, 0.2, 0.1}};
  std::vector<Vec3> normals{{1, 0, 0}};
  for (const double u : {-0.2, -0.4}) {
    for (const double v : {-0.3, -0.5}) {
      points.insert(points.end(), {{0, u, v}, {u, 0, v}, {u, v, 0}});
      normals.insert(normals.end(), {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    }
  }
  const Neighborhoods near = find_neighbors(points, {.max_count = 12});
  const FeatureField corner = all(Feature::Corner, points.size());
  PositionUpdateOptions options{
      .position_scale = 1, .feature_step = 1, .max_move = far, .quadric = Quadric::Plain};
  EXPECT_LE(norm(update_positions(points, points, normals, corner, near, options)[0]), 1e-14);
  options.quadric = Quadric::Guarded;
  EXPECT_LE(norm(update_positions(points, points, normals, corner, near, options)[0]),
            0.1 * norm(points[0]));
}

// n_i = x_i / R: (n_i + n_j)/2 . (x_j - x_i) = (|x_j|^2 - |x_i|^2) / 2R = 0, where
// n_i . (x_j - x_i) = -|x_j - x_i|^2 / 2R.
TEST(UpdatePositions, KeepsASphereWithTheSymmetricOffsetAlone) {
  const Sampled truth = sphere(2000, 3);
  const Neighborhoods near = find_neighbors(truth.points, {.max_count = 20});
  const FeatureField surface = all(Feature::Surface, truth.points.size());
  PositionUpdateOptions options{.position_scale = 0.2,
                                .normal_scale = 1e9,
                                .step = 1,
                                .max_move = far,
                                .offset = Offset::Symmetric};
  const auto update = [&] {
    return update_positions(truth.points, truth.points, truth.normals, surface, near, options);
  };
  EXPECT_LE(max_difference(update(), truth.points), 1e-15);
  options.offset = Offset::Projected;
  const std::vector<Vec3> shrunk = update();
  for (std::size_t i = 0; i < shrunk.size(); ++i) {
    double squares = 0;
    double total = 0;
    for (const std::uint32_t j : near[i]) {
      const double squared = squared_norm(truth.points[j] - truth.points[i]);
      squares += std::exp(-squared / 0.04) * squared;
      total += std::exp(-squared / 0.04);
    }
    ASSERT_NEAR(norm(shrunk[i]), 1 - squares / total / 2, 1e-13);
  }
}

TEST(UpdatePositions, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Vec3> points = random_points(4000, 6);
  const std::vector<Vec3> normals = tilted(std::vector<Vec3>(4000, up), 0.4, 7);
  const Neighborhoods near = find_neighbors(points, {.max_count = 20});
  const FeatureField field = classify_features(points, normals, near);
  const auto run = [&](int threads) {
    return update_positions(points, points, normals, field, near,
                            {.position_scale = 0.05, .max_move = 0.1}, {.threads = threads});
  };
  const std::vector<Vec3> one = run(1);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(run(threads), one);
}

TEST(UpdatePositions, NamesTheWrongOption) {
  const PositionUpdateOptions good{.position_scale = 1, .max_move = 1};
  const auto error = [&](auto change) {
    PositionUpdateOptions options = good;
    change(options);
    return invalid_argument_of([&] { (void)update_positions({}, {}, {}, {}, {}, options); });
  };
  EXPECT_EQ(error([](auto&) {}), "");
  EXPECT_EQ(error([](auto& o) { o.position_scale = 0; }),
            "position_update.position_scale must be > 0, got 0");
  EXPECT_EQ(error([](auto& o) { o.normal_scale = -1; }),
            "position_update.normal_scale must be > 0, got -1");
  EXPECT_EQ(error([](auto& o) { o.step = 1.5; }),
            "position_update.step must be in (0, 1], got 1.5");
  EXPECT_EQ(error([](auto& o) { o.feature_step = 0; }),
            "position_update.feature_step must be in (0, 1], got 0");
  EXPECT_EQ(error([](auto& o) { o.max_move = std::nan(""); }),
            "position_update.max_move must be >= 0, got nan");
  const std::vector<Vec3> two(2);
  EXPECT_EQ(invalid_argument_of([&] { (void)update_positions(two, two, two, {}, {}, good); }),
            "neighborhoods must have one entry per point (2), got 0");
  EXPECT_EQ(invalid_argument_of([&] {
              (void)update_positions(two, two, two, {}, find_neighbors(two, {.max_count = 1}),
                                     good);
            }),
            "features.label must have one entry per point (2), got 0");
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "deburr/position_update.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"
#include "support/stage_oracle.hpp"

namespace deburr {
namespace {

using testing::HasSubstr;

constexpr Vec3 up{0, 0, 1};
constexpr double far = 1e9;  // a bound that is never met

FeatureField all(Feature label, std::size_t n, const Vec3& direction = {}) {
  return {std::vector<Feature>(n, label), std::vector<Vec3>(n, direction)};
}

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

TEST(UpdatePositions, MovesAlongTheNormalByTheStep) {
  OverPlane over;
  EXPECT_LE(norm(over.moved()), 1e-15);
  over.options.step = 0.25;
  EXPECT_LE(norm(over.moved() - Vec3{0, 0, 0.75}), 1e-15);
}

TEST(UpdatePositions, ClampsAtTheBoundFromTheOriginal) {
  OverPlane over;
  over.options.bound = Bound::Clamp;
  over.options.max_move = 0.4;
  EXPECT_LE(norm(over.moved() - Vec3{0, 0, 0.6}), 1e-15);
  over.original[0] = {0, 0, 1.2};
  EXPECT_LE(norm(over.moved() - Vec3{0, 0, 0.8}), 1e-15);
  over.original[0] = {0, 0.3, 0.4};  // 0.5 from the origin: four fifths of the way to it
  EXPECT_LE(norm(over.moved() - Vec3{0, 0.06, 0.08}), 1e-15);
}

TEST(UpdatePositions, StaysAtTheOriginalWithABoundOfZero) {
  for (const Bound bound : {Bound::Clamp, Bound::Reject}) {
    OverPlane over;
    over.options.bound = bound;
    over.options.max_move = 0;
    EXPECT_EQ(over.moved(), over.points[0]);
    over.points[0].z = over.original[0].z = 0;  // no move at all
    EXPECT_EQ(over.moved(), over.points[0]);
  }
}

TEST(UpdatePositions, RejectsAMoveBeyondTheBound) {
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

TEST(UpdatePositions, StaysFiniteWhereTheQuadricIsSingular) {
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
TEST(UpdatePositions, GuardedQuadricReachesThePlaneOfCoplanarNeighbors) {
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
TEST(UpdatePositions, GuardedQuadricStaysInItsPlane) {
  const Sampled plane = plane_grid(7);
  const auto moved = update_positions(
      plane.points, plane.points, plane.normals, all(Feature::Corner, plane.points.size()),
      find_neighbors(plane.points, {.max_count = 8}), {.position_scale = 1, .max_move = far});
  EXPECT_LE(max_difference(moved, plane.points), 1e-15);
}

TEST(UpdatePositions, LeavesPointsWithoutNeighborsAndIsolatedOnesAlone) {
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

/// Points, normals and options on which the class of a point depends on where the others are.
struct Sweep {
  std::vector<Vec3> original = random_points(150, 8);
  std::vector<Vec3> normals = tilted(std::vector<Vec3>(150, up), 0.5, 9);
  Neighborhoods near = find_neighbors(original, {.radius = 0.3});
  FeatureOptions features{.rho = 0.8};
  PositionUpdateOptions options{.position_scale = 0.2,
                                .normal_scale = 0.5,
                                .step = 0.5,
                                .feature_step = 1,
                                .max_move = 0.2,
                                .offset = Offset::Projected,
                                .quadric = Quadric::Plain,
                                .bound = Bound::Reject};

  /// By the definition, with the public functions.
  void slow(std::vector<Vec3>& points, FeatureField& field,
            const std::vector<std::uint32_t>& order) const {
    for (const std::uint32_t i : order) {
      const FeatureField now = classify_features(points, normals, near, features);
      field.label[i] = now.label[i];
      field.direction[i] = now.direction[i];
      points[i] = update_positions(original, points, normals, now, near, options)[i];
    }
  }
};

TEST(SweepInPlace, EqualsTheSlowWayInAnyOrder) {
  const Sweep sweep;
  std::vector<std::uint32_t> by_index(150);
  for (std::uint32_t i = 0; i < 150; ++i) by_index[i] = i;
  std::vector<std::uint32_t> some = random_permutation(150, 10);
  some.resize(60);
  for (const auto& order : {by_index, random_permutation(150, 11), some}) {
    std::vector<Vec3> expected = sweep.original;
    FeatureField labels = all(Feature::Isolated, 150);
    sweep.slow(expected, labels, order);
    std::vector<Vec3> points = sweep.original;
    const FeatureField field = sweep_in_place(sweep.original, points, sweep.normals, sweep.near,
                                              sweep.features, sweep.options, order);
    EXPECT_LE(max_difference(points, expected), 1e-12);
    EXPECT_EQ(field.label, labels.label);
    EXPECT_LE(max_difference_of_lines(field.direction, labels.direction), 1e-12);
  }
}

TEST(SweepInPlace, GoesByIndexWithoutAnOrder) {
  const Sweep sweep;
  std::vector<std::uint32_t> by_index(150);
  for (std::uint32_t i = 0; i < 150; ++i) by_index[i] = i;
  std::vector<Vec3> given = sweep.original;
  std::vector<Vec3> none = sweep.original;
  std::vector<Vec3> other = sweep.original;
  sweep_in_place(sweep.original, given, sweep.normals, sweep.near, sweep.features, sweep.options,
                 by_index);
  sweep_in_place(sweep.original, none, sweep.normals, sweep.near, sweep.features, sweep.options);
  EXPECT_EQ(given, none);
  sweep_in_place(sweep.original, other, sweep.normals, sweep.near, sweep.features, sweep.options,
                 random_permutation(150, 12));
  EXPECT_NE(given, other);
}

TEST(SweepInPlace, SeesTheNewPositionsOfThoseBefore) {
  const Sweep sweep;
  std::vector<Vec3> points = sweep.original;
  sweep_in_place(sweep.original, points, sweep.normals, sweep.near, sweep.features, sweep.options);
  const FeatureField field =
      classify_features(sweep.original, sweep.normals, sweep.near, sweep.features);
  const std::vector<Vec3> at_once = update_positions(sweep.original, sweep.original, sweep.normals,
                                                     field, sweep.near, sweep.options);
  EXPECT_LE(norm(points[0] - at_once[0]), 1e-15);
  EXPECT_GT(max_difference(points, at_once), 1e-3);
}

TEST(SweepInPlace, RefusesAWrongOrderOrOption) {
  Sweep sweep;
  const auto error = [&](const std::vector<std::uint32_t>& order) {
    std::vector<Vec3> points = sweep.original;
    return invalid_argument_of([&] {
      sweep_in_place(sweep.original, points, sweep.normals, sweep.near, sweep.features,
                     sweep.options, order);
    });
  };
  EXPECT_EQ(error({0, 1}), "");
  EXPECT_THAT(error({0, 150}), HasSubstr("order"));
  EXPECT_THAT(error({0, 150}), HasSubstr("150"));
  sweep.features.tau = 2;
  EXPECT_THAT(error({}), HasSubstr("features.tau"));
}

}  // namespace
}  // namespace deburr

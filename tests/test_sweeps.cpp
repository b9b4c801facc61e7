// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <vector>

#include "deburr/position_update.hpp"
#include "support/compare.hpp"
#include "support/feature_field.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

using testing::HasSubstr;

constexpr Vec3 up{0, 0, 1};

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

TEST(SweepAtOnce, HasTheBitsOfItsTwoStages) {
  const Sweep sweep;
  const FeatureField expected =
      classify_features(sweep.original, sweep.normals, sweep.near, sweep.features);
  std::vector<Vec3> points = sweep.original;
  const FeatureField field = sweep_at_once(sweep.original, points, sweep.normals, sweep.near,
                                           sweep.features, sweep.options);
  EXPECT_EQ(points, update_positions(sweep.original, sweep.original, sweep.normals, expected,
                                     sweep.near, sweep.options));
  EXPECT_EQ(field.label, expected.label);
  EXPECT_EQ(field.direction, expected.direction);
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

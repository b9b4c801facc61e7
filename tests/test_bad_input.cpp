// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <numeric>
#include <ostream>
#include <string>
#include <tuple>
#include <vector>

#include "deburr/denoise.hpp"
#include "deburr/error.hpp"
#include "support/compare.hpp"
#include "support/same_cloud.hpp"
#include "support/shapes.hpp"

// Clouds that no scanner should give, but some do.

namespace deburr {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double denormal = std::numeric_limits<double>::denorm_min();

std::vector<Vec3> noisy_sphere(double unit = 1, const Vec3& middle = {}) {
  return mapped(with_noise(sphere(600, 1).points, 0.05, 2),
                [&](const Vec3& p) { return middle + unit * p; });
}

std::vector<Vec3> some_not_finite() {
  std::vector<Vec3> points = noisy_sphere();
  for (std::size_t i = 0; i < points.size(); i += 7) points[i].x = not_a_number;
  for (std::size_t i = 3; i < points.size(); i += 11) points[i].y = infinity;
  for (std::size_t i = 5; i < points.size(); i += 13) points[i].z = -infinity;
  return points;
}

std::vector<Vec3> many_duplicates() {
  std::vector<Vec3> points = noisy_sphere();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 10 < 3) points[i] = points[(i * 7) % 100];
  }
  return points;
}

std::vector<Vec3> line() {
  const Vec3 along = random_directions(1, 3)[0];
  std::vector<Vec3> points(100);
  for (std::size_t k = 0; k < points.size(); ++k)
    points[k] = (0.1 * static_cast<double>(k)) * along;
  return points;
}

std::vector<Vec3> with_extremes(double extreme) {
  std::vector<Vec3> points = noisy_sphere();
  points.push_back({extreme, extreme, extreme});
  points.push_back({-extreme, -extreme, -extreme});
  points.push_back({extreme, -extreme, 0});
  return points;
}

std::vector<Vec3> two_piles() {
  std::vector<Vec3> points(300, Vec3{1, 2, 3});
  points.insert(points.end(), 300, Vec3{3, 2, 1});
  return points;
}

struct Case {
  std::string name;
  std::vector<Vec3> points;

  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"Empty", {}},
      {"OnePoint", random_points(1, 4)},
      {"TwoPoints", random_points(2, 4)},
      {"ThreePoints", random_points(3, 4)},
      {"FourPoints", random_points(4, 4)},
      {"FivePoints", random_points(5, 4)},
      {"FifteenPoints", random_points(15, 4)},
      {"TwentyPoints", random_points(20, 4)},
      {"EqualPoints", std::vector<Vec3>(50, {1, 2, 3})},
      {"ManyEqualPoints", std::vector<Vec3>(200000, {1, 2, 3})},
      {"TwoPiles", two_piles()},
      {"Line", line()},
      {"AxisLine", mapped(line(),
                          [](const Vec3& p) {
                            return Vec3{norm(p), 0, 0};
                          })},
      {"ExactGrid", plane_grid(15).points},
      {"IntegerLattice", grid_points(500, 5)},
      {"SomeNotFinite", some_not_finite()},
      {"NoneFinite", std::vector<Vec3>(30, {not_a_number, infinity, -infinity})},
      {"Duplicates", many_duplicates()},
      {"FarFromTheOrigin", noisy_sphere(0.012, {1e7, -1e7, 1e7})},
      {"Scale1em9", noisy_sphere(1e-9)},
      {"Scale1em200", noisy_sphere(1e-200)},
      {"Scale1e200", noisy_sphere(1e200)},
      {"Scale1e307", noisy_sphere(1e307)},
      {"Denormal", noisy_sphere(1e-320)},
      {"FewDenormals", mapped(grid_points(50, 6), [](const Vec3& p) { return denormal * p; })},
      {"Extreme1e100", with_extremes(1e100)},
      {"Extreme1e308", with_extremes(1e308)},
      {"ExtremesAlone", {{1e308, 0, 0}, {-1e308, 0, 0}, {0, 1e308, 0}, {0, 0, -1e308}, {1, 1, 1}}},
  };
  return all;
}

class BadInput : public testing::TestWithParam<std::tuple<Case, Method>> {};

TEST_P(BadInput, HasADefinedResult) {
  const auto& [given, method] = GetParam();
  const std::size_t n = given.points.size();
  PointCloud cloud;
  cloud.points = given.points;
  std::vector<std::vector<Vec3>> normals{{}, random_directions(n, 7)};
  if (n > 1) {
    normals[1][0] = {};
    normals[1][1] = {not_a_number, infinity, 0};
  }
  for (const std::vector<Vec3>& start : normals) {
    cloud.normals = start;
    DenoiseResult result;
    try {
      result = denoise(cloud, {.method = method});
    } catch (const DataError&) {
      continue;  // a refusal is defined as well
    }
    ASSERT_EQ(result.cloud.size(), n);
    ASSERT_EQ(result.cloud.normals.size(), n);
    ASSERT_EQ(result.labels.size(), n);
    ASSERT_EQ(result.displacement.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      if (is_finite(cloud.points[i])) {
        ASSERT_TRUE(is_finite(result.cloud.points[i])) << i;
        ASSERT_TRUE(std::isfinite(result.displacement[i])) << i;
        ASSERT_TRUE(is_finite(result.cloud.normals[i])) << i;
      } else {
        ASSERT_TRUE(same_bits(result.cloud.points[i], cloud.points[i])) << i;
        ASSERT_EQ(result.labels[i], Feature::Isolated) << i;
      }
    }
    const auto& counts = result.report.labels;
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), std::size_t{0}), n);
  }
}

INSTANTIATE_TEST_SUITE_P(AllCases, BadInput,
                         testing::Combine(testing::ValuesIn(cases()),
                                          testing::Values(Method::Auto, Method::Yadav2018)),
                         [](const auto& run) {
                           return std::get<Case>(run.param).name +
                                  (std::get<Method>(run.param) == Method::Auto ? "_Auto"
                                                                               : "_Yadav2018");
                         });

TEST(BadInputLaws, ReturnsTooFewDistinctPointsUnchanged) {
  for (const Method method : {Method::Auto, Method::Yadav2018}) {
    const std::size_t enough = method == Method::Auto ? 16 : 4;
    for (std::size_t distinct = 1; distinct < enough; ++distinct) {
      PointCloud cloud;
      for (std::size_t i = 0; i < 40; ++i) {
        cloud.points.push_back(random_points(distinct, 8)[i % distinct]);
        cloud.normals.push_back({0, 0, 1});
      }
      const DenoiseResult result = denoise(cloud, {.method = method});
      EXPECT_TRUE(same_values(result.cloud.points, cloud.points));
      EXPECT_THAT(result.labels, testing::Each(Feature::Isolated));
      EXPECT_EQ(result.report.duplicates, 40 - distinct);
    }
  }
}

TEST(BadInputLaws, AllowsMoreNeighborsThanPoints) {
  PointCloud cloud;
  cloud.points = noisy_sphere();
  for (const Method method : {Method::Auto, Method::Yadav2018}) {
    DenoiseOptions options{.method = method};
    // Noise far larger than the cloud asks the default method for more than there are.
    options.automatic.noise = 100;
    options.automatic.max_move = 2;
    options.yadav2018.k = 100000;
    options.yadav2018.rounds = 2;
    EXPECT_LT(max_difference(denoise(cloud, options).cloud.points, cloud.points), 3);
  }
}

TEST(BadInputLaws, HidesNoMovementOfAnyScale) {
  for (const double unit : {1e-200, 1e200}) {
    PointCloud cloud;
    cloud.points = noisy_sphere(unit);
    const DenoiseResult result = denoise(cloud);
    EXPECT_NE(result.cloud.points, cloud.points);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const double moved = norm((1 / unit) * (result.cloud.points[i] - cloud.points[i]));
      ASSERT_NEAR(result.displacement[i] / unit, moved, 1e-12);
    }
  }
}

// Its own unit is part of the published method, so that it cannot choose a better one.
TEST(BadInputLaws, RefusesDistancesBeyondDoublesInThePublishedMethod) {
  PointCloud cloud;
  cloud.points = noisy_sphere(1e200);
  EXPECT_THROW((void)denoise(cloud, {.method = Method::Yadav2018}), DataError);
}

// Coplanar already: there is no noise to take off.
TEST(BadInputLaws, LeavesAnExactGridInItsPlane) {
  const Rotation turn = random_rotation(9);
  PointCloud cloud;
  cloud.points = mapped(plane_grid(20).points, turn);
  for (const Method method : {Method::Auto, Method::Yadav2018}) {
    const DenoiseResult result = denoise(cloud, {.method = method});
    EXPECT_LE(max_difference(result.cloud.points, cloud.points), 1e-12);
  }
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <tuple>

#include "deburr/normals.hpp"
#include "deburr/orientation.hpp"
#include "spatial_order.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

/// Each point with the one before and the one after it.
Neighborhoods chain(std::size_t n) {
  std::vector<std::size_t> offsets{0};
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (i > 0) indices.push_back(i - 1);
    if (i + 1 < n) indices.push_back(i + 1);
    offsets.push_back(indices.size());
  }
  return {offsets, indices};
}

/// By the definition: pieces grow from their roots by the lightest edge that leaves them (Prim).
std::vector<Vec3> slow_orientation(Points points, std::vector<Vec3> normals,
                                   const Neighborhoods& near) {
  const std::size_t n = points.size();
  std::vector<bool> done(n);
  std::vector<std::tuple<double, std::size_t, std::size_t>> edges;  // weight, both ends
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::size_t j : near[i]) {
      const double weight = 1 - std::abs(dot(normals[i], normals[j]));
      edges.emplace_back(weight, i, j);
      edges.emplace_back(weight, j, i);
    }
  }
  std::sort(edges.begin(), edges.end());
  while (true) {
    std::size_t root = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (!done[i] && (root == n || points[i].z > points[root].z)) root = i;
    }
    if (root == n) return normals;
    done[root] = true;
    if (normals[root].z < 0) normals[root] = -normals[root];
    const auto leaves = [&](const auto& edge) {
      return done[std::get<1>(edge)] && !done[std::get<2>(edge)];
    };
    for (auto edge = std::find_if(edges.begin(), edges.end(), leaves); edge != edges.end();
         edge = std::find_if(edges.begin(), edges.end(), leaves)) {
      const auto [weight, parent, child] = *edge;
      done[child] = true;
      if (dot(normals[parent], normals[child]) < 0) normals[child] = -normals[child];
    }
  }
}

TEST(OrientNormals, EqualsTheSlowWay) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const std::vector<Vec3> points = random_points(150, seed);
    const std::vector<Vec3> normals = random_directions(150, seed + 100);
    // Two neighbours leave many pieces, six leave one.
    for (const std::size_t k : {2, 6}) {
      const Neighborhoods near = find_neighbors(points, {.max_count = k});
      EXPECT_EQ(orient_normals(points, normals, near), slow_orientation(points, normals, near));
    }
  }
}

TEST(OrientNormals, TurnsASphereOutward) {
  const Sampled truth = sphere(3000, 1);
  const Neighborhoods near = find_neighbors(truth.points, {.max_count = 12});
  const std::vector<Vec3> normals = with_random_signs(estimate_normals(truth.points, near), 2);
  const std::vector<Vec3> oriented = orient_normals(truth.points, normals, near);
  for (std::size_t i = 0; i < oriented.size(); ++i) {
    ASSERT_GT(dot(oriented[i], truth.normals[i]), 0.9);
    ASSERT_TRUE(oriented[i] == normals[i] || oriented[i] == -normals[i]);
  }
}

TEST(OrientNormals, DoesNotDependOnTheSigns) {
  const std::vector<Vec3> points = random_points(500, 3);
  const std::vector<Vec3> normals = random_directions(500, 4);
  const Neighborhoods near = find_neighbors(points, {.max_count = 4});
  const std::vector<Vec3> oriented = orient_normals(points, normals, near);
  for (unsigned seed = 5; seed < 10; ++seed) {
    EXPECT_EQ(orient_normals(points, with_random_signs(normals, seed), near), oriented);
  }
}

// In spatial order or in none, which take different ways.
TEST(OrientNormals, DoesNotDependOnTheOrder) {
  const Sampled truth = sphere(2000, 11);
  const Neighborhoods near = find_neighbors(truth.points, {.max_count = 8});
  const std::vector<Vec3> normals = random_directions(2000, 12);
  const std::vector<Vec3> oriented = orient_normals(truth.points, normals, near);
  const std::vector<std::uint32_t> order = spatial_order(truth.points, {});
  const std::vector<Vec3> points = gather<Vec3>(truth.points, order);
  const std::vector<Vec3> along = orient_normals(points, gather<Vec3>(normals, order),
                                                 find_neighbors(points, {.max_count = 8}));
  EXPECT_EQ(along, gather<Vec3>(oriented, order));
}

TEST(OrientNormals, OrientsEachPieceByItsOwnRoot) {
  const Sampled truth = sphere(500, 6);
  std::vector<Vec3> points = truth.points;
  for (const Vec3& p : truth.points) points.push_back(p + Vec3{10, 0, -5});
  std::vector<Vec3> normals = truth.normals;
  normals.insert(normals.end(), truth.normals.begin(), truth.normals.end());
  const std::vector<Vec3> oriented = orient_normals(points, with_random_signs(normals, 7),
                                                    find_neighbors(points, {.max_count = 12}));
  EXPECT_EQ(oriented, normals);
}

TEST(OrientNormals, LetsZeroNormalsTakeNoPart) {
  const std::vector<Vec3> points{{0, 0, 3}, {0, 0, 2}, {0, 0, 1}};
  // The zero normal in the middle parts the chain: the last point is a root of its own.
  EXPECT_THAT(orient_normals(points, std::vector<Vec3>{{0, 0, -1}, {}, {0, 0, -1}}, chain(3)),
              ElementsAre(Vec3{0, 0, 1}, Vec3{}, Vec3{0, 0, 1}));
  const Vec3 sideways{0.8, 0, -0.6};
  EXPECT_THAT(orient_normals(points, std::vector<Vec3>{{-1, 0, 0}, {}, sideways}, chain(3)),
              ElementsAre(Vec3{1, 0, 0}, Vec3{}, -sideways));
  // The same with the zero normal as the last point, next to both others.
  const Neighborhoods last_between({0, 1, 2, 4}, {2, 2, 0, 1});
  EXPECT_THAT(orient_normals(points, std::vector<Vec3>{{-1, 0, 0}, sideways, {}}, last_between),
              ElementsAre(Vec3{1, 0, 0}, -sideways, Vec3{}));
  EXPECT_THAT(orient_normals(points, std::vector<Vec3>(3), chain(3)), Each(Vec3{}));
}

TEST(OrientNormals, TurnsTheRootUp) {
  const auto oriented = [](const Vec3& normal) {
    return orient_normals(std::vector<Vec3>(1), std::vector<Vec3>{normal}, chain(1))[0];
  };
  EXPECT_EQ(oriented({0.8, 0, -0.6}), (Vec3{-0.8, 0, 0.6}));
  EXPECT_EQ(oriented({0.8, 0, 0.6}), (Vec3{0.8, 0, 0.6}));
  EXPECT_EQ(oriented({0.8, -0.6, 0}), (Vec3{-0.8, 0.6, 0}));
  EXPECT_EQ(oriented({-0.8, 0.6, 0}), (Vec3{-0.8, 0.6, 0}));
  EXPECT_EQ(oriented({-1, 0, 0}), (Vec3{1, 0, 0}));
  EXPECT_EQ(oriented({1, 0, 0}), (Vec3{1, 0, 0}));
}

TEST(OrientNormals, TakesTheHighestPointForTheRoot) {
  // Both point up, but away from each other: the root keeps its side and turns the other.
  const Vec3 a{0.8, 0, 0.6};
  const Vec3 b{-0.8, 0, 0.6};
  const auto oriented = [&](double first_z, double second_z) {
    const std::vector<Vec3> points{{0, 0, first_z}, {1, 0, second_z}};
    return orient_normals(points, std::vector<Vec3>{a, b}, chain(2));
  };
  EXPECT_THAT(oriented(2, 1), ElementsAre(a, -b));
  EXPECT_THAT(oriented(1, 2), ElementsAre(-a, b));
  EXPECT_THAT(oriented(1, 1), ElementsAre(a, -b));  // a tie: the smaller index
}

TEST(OrientNormals, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Vec3> points = random_points(4000, 8);
  const std::vector<Vec3> normals = random_directions(4000, 9);
  const Neighborhoods near = find_neighbors(points, {.max_count = 12});
  const std::vector<Vec3> one = orient_normals(points, normals, near, {.threads = 1});
  for (const int threads : {2, 3, 7}) {
    EXPECT_EQ(orient_normals(points, normals, near, {.threads = threads}), one);
  }
}

TEST(OrientNormals, IsDefinedForFewPoints) {
  EXPECT_THAT(orient_normals({}, {}, {}), IsEmpty());
  const std::vector<Vec3> one{{1, 2, 3}};
  const std::vector<Vec3> down{{0, 0, -1}};
  EXPECT_THAT(orient_normals(one, down, find_neighbors(one, {.max_count = 3})),
              ElementsAre(Vec3{0, 0, 1}));
}

TEST(OrientNormals, RefusesDifferentSizes) {
  const std::vector<Vec3> two(2);
  EXPECT_EQ(invalid_argument_of([&] { (void)orient_normals(two, {}, chain(2)); }),
            "normals must have one entry per point (2), got 0");
  EXPECT_EQ(invalid_argument_of([&] { (void)orient_normals(two, two, chain(3)); }),
            "neighborhoods must have one entry per point (2), got 3");
}

}  // namespace
}  // namespace deburr

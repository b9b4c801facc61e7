// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "box.hpp"
#include "deburr/error.hpp"
#include "deburr/metrics.hpp"
#include "deburr/synth.hpp"
#include "support/compare.hpp"
#include "synth_outliers.hpp"

namespace deburr {
namespace {

/// Points of the scan with this mask, in their order.
std::vector<Vec3> select(const SyntheticScan& scan, const std::vector<Vec3>& of,
                         std::uint8_t mask) {
  std::vector<Vec3> selected;
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (scan.outlier[i] == mask) selected.push_back(of[i]);
  }
  return selected;
}

std::vector<Vec3> sorted(std::vector<Vec3> points) {
  std::ranges::sort(points, {}, [](const Vec3& p) { return std::tuple(p.x, p.y, p.z); });
  return points;
}

TEST(SynthOutliers, AreAddedToTheSamePointsAndKnownByTheMask) {
  const SynthOptions without{.points = 3000, .noise = 0.01, .seed = 9};
  SynthOptions with = without;
  with.outliers = 0.05;
  with.cluster_outliers = 0.02;
  for (const Shape shape : {Shape::Part, Shape::Sphere, Shape::ThinPlate}) {
    const SyntheticScan a = synthesize(shape, without);
    const SyntheticScan b = synthesize(shape, with);
    EXPECT_EQ(a.cloud.size(), 3000U);
    EXPECT_EQ(std::ranges::count(a.outlier, 1), 0);
    ASSERT_EQ(b.cloud.size(), 3000U + 150 + 60);
    for (const std::size_t size : {b.clean.size(), b.normals.size(), b.outlier.size()}) {
      EXPECT_EQ(size, b.cloud.size());
    }
    EXPECT_EQ(std::ranges::count(b.outlier, 1), 150 + 60);
    EXPECT_EQ(sorted(select(b, b.cloud.points, 0)), sorted(a.cloud.points));
    EXPECT_EQ(sorted(select(b, b.clean, 0)), sorted(a.clean));
    EXPECT_EQ(select(b, b.cloud.points, 1), select(b, b.clean, 1));
    for (const Vec3& normal : select(b, b.normals, 1)) EXPECT_EQ(normal, Vec3{});
    // What belongs to one point stayed together.
    const double reach = 6 * b.sigma;
    for (std::size_t i = 0; i < b.cloud.size(); ++i) {
      ASSERT_LT(norm(b.cloud.points[i] - b.clean[i]), reach);
    }
  }
}

TEST(SynthOutliers, StandAnywhereInTheOrder) {
  const SyntheticScan scan =
      synthesize(Shape::Cube, {.points = 4000, .outliers = 0.5, .cluster_outliers = 0.5});
  ASSERT_EQ(scan.cloud.size(), 8000U);
  std::array<double, 8> counts{};
  int changes = 0;
  for (std::size_t i = 0; i < 8000; ++i) {
    counts.at(i / 1000) += scan.outlier[i];
    changes += i > 0 && scan.outlier[i] != scan.outlier[i - 1] ? 1 : 0;
  }
  for (const double count : counts) EXPECT_NEAR(count, 500, 5 * std::sqrt(250.0));
  EXPECT_NEAR(changes, 4000, 5 * std::sqrt(2000.0));
}

TEST(SynthOutliers, AreUniformInTwiceTheBox) {
  const SyntheticScan scan = synthesize(Shape::Part, {.points = 20000, .outliers = 1});
  const std::vector<Vec3> outliers = select(scan, scan.cloud.points, 1);
  ASSERT_EQ(outliers.size(), 20000U);
  std::array<double, 8> counts{};
  for (const Vec3& p : outliers) {
    ASSERT_TRUE(p.x >= -50 && p.x <= 150 && p.y >= -30 && p.y <= 90 && p.z >= -20 && p.z <= 60);
    counts.at((p.x < 0 ? 1U : 0U) + (p.y < 0 ? 2U : 0U) + (p.z > 40 ? 4U : 0U)) += 1;
  }
  // Along each axis a quarter lies beyond one side of the box itself.
  for (std::size_t k = 0; k < 8; ++k) {
    const int beyond = static_cast<int>((k & 1) + (k >> 1 & 1) + (k >> 2 & 1));
    const double expected = 20000 * std::pow(0.25, beyond) * std::pow(0.75, 3 - beyond);
    EXPECT_NEAR(counts.at(k), expected, 4 * std::sqrt(expected)) << k;
  }
}

TEST(SynthOutliers, LeaveAPlateThatIsThinnerThanATenthOfItsDiagonal) {
  const Box box = outlier_box({{0, 0, 0}, {3, 4, 0}});
  EXPECT_EQ(box.low, (Vec3{-1.5, -2, -0.5}));
  EXPECT_EQ(box.high, (Vec3{4.5, 6, 0.5}));
}

TEST(SynthOutliers, ClustersAreSmallDenseAndOffTheSurface) {
  const SyntheticScan scan = synthesize(
      Shape::Torus, {.points = 20000, .noise = 0.01, .cluster_outliers = 0.1, .seed = 3});
  const std::vector<Vec3> outliers = select(scan, scan.cloud.points, 1);
  ASSERT_EQ(outliers.size(), 2000U);
  const double radius = 1.5 * scan.spacing;
  // Flood over gaps of a radius: in a ball there are none, and balls are mostly far apart.
  std::vector<int> cluster(outliers.size(), -1);
  std::vector<std::size_t> sizes;
  for (std::size_t seed = 0; seed < outliers.size(); ++seed) {
    if (cluster[seed] >= 0) continue;
    std::vector<std::size_t> open{seed};
    cluster[seed] = static_cast<int>(sizes.size());
    std::size_t size = 0;
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      ++size;
      for (std::size_t j = 0; j < outliers.size(); ++j) {
        if (cluster[j] >= 0 || norm(outliers[i] - outliers[j]) > radius) continue;
        ASSERT_LE(norm(outliers[seed] - outliers[j]), 2 * radius);
        cluster[j] = cluster[seed];
        open.push_back(j);
      }
    }
    sizes.push_back(size);
  }
  EXPECT_GE(std::ranges::min(sizes), 15U);
  EXPECT_LE(std::ranges::max(sizes), 60U);
  EXPECT_GT(std::ranges::max(sizes), std::ranges::min(sizes) + 20);
  const double clearance = 6 * scan.spacing + 5 * scan.sigma - radius;
  for (const double d : distance_to_surface(outliers, scan.truth)) ASSERT_GE(d, clearance);
}

TEST(SynthOutliers, AnyNumberMakesClusters) {
  const TriangleMesh cube = shape_mesh(Shape::Cube);
  const Box box{{-1, -1, -1}, {2, 2, 2}};
  Random random(1);
  for (std::size_t count = 0; count < 200; ++count) {
    const std::vector<Vec3> points = clustered_outliers(count, 0.01, 0.1, cube, box, random);
    ASSERT_EQ(points.size(), count);
    // Cluster by cluster, so that they can be told apart by the way from one to the next.
    std::size_t size = 0;
    for (std::size_t i = 0; i < count; ++i) {
      ++size;
      if (i + 1 < count && norm(points[i + 1] - points[i]) <= 0.02) continue;
      EXPECT_GE(size, std::min<std::size_t>(count, 15)) << count;
      EXPECT_LE(size, 60U) << count;
      size = 0;
    }
  }
}

TEST(SynthOutliers, ASurfaceWithoutRoomForClustersIsRefused) {
  try {
    (void)synthesize(Shape::Cube, {.points = 100, .cluster_outliers = 0.1});
    FAIL() << "no error";
  } catch (const DataError& e) {
    EXPECT_THAT(e.what(), testing::StartsWith("synth.cluster_outliers: no place in twice the"));
  }
}

TEST(SynthOutliers, SharesOutOfRangeAreNamed) {
  const auto message = [](const SynthOptions& options) {
    return invalid_argument_of([&] { (void)synthesize(Shape::Cube, options); });
  };
  EXPECT_EQ(message({.points = 10, .outliers = -0.1}),
            "synth.outliers must be in [0, 1], got -0.1");
  EXPECT_EQ(message({.points = 10, .outliers = std::nan("")}),
            "synth.outliers must be in [0, 1], got nan");
  EXPECT_EQ(message({.points = 10, .cluster_outliers = 1.5}),
            "synth.cluster_outliers must be in [0, 1], got 1.5");
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "deburr/error.hpp"
#include "deburr/metrics.hpp"
#include "deburr/synth.hpp"
#include "triangle_bvh.hpp"

namespace deburr {
namespace {

/// Triangles of this size at the ends of a box of length 1.
TriangleMesh two_specks(double size) {
  TriangleMesh specks;
  for (const double x : {0.0, 1.0}) {
    const auto first = static_cast<std::uint32_t>(specks.vertices.size());
    specks.vertices.insert(specks.vertices.end(), {{x, 0, 0}, {x, size, 0}, {x, 0, size}});
    specks.triangles.push_back({first, first + 1, first + 2});
  }
  return specks;
}

SynthOptions clean(Sampling sampling, std::size_t points, std::uint64_t seed = 1) {
  return {.points = points, .noise = 0, .sampling = sampling, .seed = seed};
}

TEST(ScannerSampling, SeesWhatNothingHides) {
  const SyntheticScan scan = synthesize(Shape::Part, clean(Sampling::Scanner, 3000));
  EXPECT_LT(compare_to_surface(scan.cloud.points, scan.truth).maximum, 1e-13);
  const Vec3 centre{50, 30, 20};
  const double diagonal = std::sqrt(100.0 * 100 + 60 * 60 + 40 * 40);
  const TriangleBvh bvh(scan.truth);
  std::size_t scanner = 0;
  std::array<int, 4> seen{};
  const std::array<Vec3, 4> corners{Vec3{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}};
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    // In the order of the scan: by one scanner after the other.
    const Vec3& p = scan.cloud.points[i];
    const auto visible = [&] {
      const Vec3 from = centre + 1.5 * diagonal / std::sqrt(3.0) * corners.at(scanner);
      const std::optional<RayHit> hit = bvh.first_hit(from, p - from);
      return hit && std::abs(hit->distance - 1) < 1e-9 && dot(scan.normals[i], p - from) <= 1e-9;
    };
    while (!visible()) ASSERT_LT(++scanner, 4U) << i;
    ++seen.at(scanner);
  }
  for (const int count : seen) EXPECT_GT(count, 300);
}

// A cube in a cube is not seen, although a quarter of the area is its.
TEST(ScannerSampling, MissesHiddenParts) {
  TriangleMesh nested = shape_mesh(Shape::Cube);
  const TriangleMesh cube = nested;
  for (const Vec3& p : cube.vertices) {
    nested.vertices.push_back(Vec3{0.2, 0.2, 0.2} + 0.6 * p);
  }
  for (const auto& [i, j, k] : cube.triangles) nested.triangles.push_back({i + 8, j + 8, k + 8});
  const auto inside = [&](Sampling sampling) {
    const SyntheticScan scan = synthesize(nested, clean(sampling, 4000));
    return std::ranges::count_if(scan.cloud.points, [](const Vec3& p) {
      return std::min({p.x, p.y, p.z, 1 - p.x, 1 - p.y, 1 - p.z}) > 0.1;
    });
  };
  EXPECT_NEAR(static_cast<double>(inside(Sampling::Uniform)), 4000 * 0.36 / 1.36, 150);
  EXPECT_EQ(inside(Sampling::Scanner), 0);
}

// Seen from the first scanner, points of a scan lie on lines of equal elevation.
TEST(ScannerSampling, FollowsAGridOfEqualAngles) {
  const SyntheticScan scan = synthesize(Shape::Cube, clean(Sampling::Scanner, 2000));
  const Vec3 from = Vec3{0.5, 0.5, 0.5} + 1.5 * Vec3{1, 1, 1};
  const Vec3 ahead = (-1 / std::sqrt(3.0)) * Vec3{1, 1, 1};
  const Vec3 right = std::sqrt(0.5) * Vec3{-1, 1, 0};
  const Vec3 up = cross(right, ahead);
  std::vector<double> elevations;
  std::vector<double> azimuths;
  for (std::size_t i = 0; i < 400; ++i) {
    const Vec3 d = scan.cloud.points[i] - from;
    elevations.push_back(std::atan2(dot(d, up), std::hypot(dot(d, ahead), dot(d, right))));
    azimuths.push_back(std::atan2(dot(d, right), dot(d, ahead)));
  }
  EXPECT_TRUE(std::is_sorted(elevations.begin(), elevations.end(),
                             [](double a, double b) { return a < b - 1e-9; }));
  for (std::vector<double>* angles : {&elevations, &azimuths}) {
    std::ranges::sort(*angles);
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < angles->size(); ++i) {
      const double gap = (*angles)[i] - (*angles)[i - 1];
      if (gap > 1e-9) step = std::min(step, gap);
    }
    EXPECT_GT(step, 0.005);
    for (const double a : *angles) {
      const double steps = (a - angles->front()) / step;
      ASSERT_NEAR(steps, std::round(steps), 1e-9);
    }
    // The seed shifts the grid: none of its lines goes through the middle of the view.
    const double shift = angles->front() / step;
    EXPECT_GT(std::abs(shift - std::round(shift)), 1e-3);
  }
}

TEST(ScannerSampling, IsDenserWhereTheScannerIsNearer) {
  const TriangleMesh square{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const SyntheticScan scan = synthesize(square, clean(Sampling::Scanner, 40000));
  const double away = 1.5 * std::sqrt(2.0) / std::sqrt(3.0);
  const Vec3 from = Vec3{0.5, 0.5, 0} + away * Vec3{1, 1, 1};
  const Vec3 axis = (1 / std::sqrt(6.0)) * Vec3{-1, -1, 2};  // of the lines of equal azimuth
  // The corner cells nearest to the first scanner and farthest from it. It sees the cosine to the
  // surface over the square of the distance; over the cosine of the elevation as well, since the
  // columns of a grid of equal angles draw nearer with it.
  std::array<double, 2> expected{};
  std::array<double, 2> counts{};
  for (std::size_t k = 0; k < 2; ++k) {
    const double corner = k == 0 ? 0.75 : 0;
    for (int i = 0; i < 100; ++i) {
      const Vec3 p{corner + 0.25 * (i % 10 + 0.5) / 10, corner + 0.25 * (i / 10 + 0.5) / 10, 0};
      const Vec3 ray = p - from;
      const double sin_up = dot(ray, axis) / norm(ray);
      expected.at(k) += std::abs(ray.z) / (std::pow(norm(ray), 3) * std::sqrt(1 - sin_up * sin_up));
    }
  }
  // The first scanner's points are those before its elevation falls.
  double last = -1;
  for (const Vec3& p : scan.cloud.points) {
    const double sin_up = dot(p - from, axis) / norm(p - from);
    if (sin_up < last - 1e-9) break;
    last = sin_up;
    if (std::min(p.x, p.y) >= 0.75) counts[0] += 1;
    if (std::max(p.x, p.y) < 0.25) counts[1] += 1;
  }
  EXPECT_GT(expected[0] / expected[1], 1.5);
  EXPECT_NEAR(counts[0] / counts[1], expected[0] / expected[1], 0.25);
}

TEST(ScannerSampling, ASurfaceThatNoRayMeetsIsRefused) {
  const TriangleMesh specks = two_specks(1e-6);
  EXPECT_THROW((void)synthesize(specks, clean(Sampling::Scanner, 10)), DataError);
  EXPECT_EQ(synthesize(specks, clean(Sampling::Uniform, 10)).cloud.size(), 10U);
}

TEST(ScannerSampling, NeverFallsBackWhereOneScanIsNotEnough) {
  // Specks that a first scan hardly meets, so that several are needed.
  double last = 0;
  int told = 0;
  (void)synthesize(two_specks(0.03), clean(Sampling::Scanner, 200),
                   {.progress = [&](const Progress& p) {
                     EXPECT_GE(p.fraction, last);
                     last = p.fraction;
                     ++told;
                   }});
  EXPECT_GT(told, 4);  // once for each scanner, had one scan been enough
}

}  // namespace
}  // namespace deburr

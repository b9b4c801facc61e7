// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "belonging.hpp"
#include "lane_sums.hpp"
#include "random.hpp"
#include "sheet_samples.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

/// Nodes about a plane, one of them without a normal, and what is found around its origin.
struct Scene {
  SurfaceNodes nodes;
  Frame frame;
  std::vector<Found> found;

  explicit Scene(std::size_t count) : frame(frame_along({3, -2, 5}, unit({1, 2, 3}))) {
    Random random(7);
    const auto off = [&](double by) { return by * (2 * random.uniform() - 1); };
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vec3 at = frame.origin + off(1) * frame.u + off(1) * frame.v;
      nodes.places.push_back(at + off(0.05) * frame.w);
      nodes.measured.push_back(at + off(0.2) * frame.w);
      nodes.normals.push_back(i == 5 ? Vec3{}
                                     : unit(frame.w + off(0.3) * frame.u + off(0.3) * frame.v));
      nodes.weights.push_back(1 + std::floor(3 * random.uniform()));
      nodes.trust.push_back(0.2 + 0.8 * random.uniform());
      found.push_back({squared_norm(nodes.places[i] - frame.origin), i});
    }
    std::sort(found.begin(), found.end());
  }
};

/// The sums by their definition, and the variance of what a pull makes of the samples.
double sum_up(const Scene& scene, std::size_t count, const SheetSamples::Membership& member,
              const HeightQuadric& pull, double scale, WeightedQuadric::Sums& to) {
  double variance = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Found& f = scene.found[i];
    const Vec3 p = scene.frame.local(scene.nodes.places[f.index]);
    const double slope_x = member.surface.slope_x(p.x, p.y);
    const double slope_y = member.surface.slope_y(p.x, p.y);
    const Vec3 normal = unit(scene.frame.w - slope_x * scene.frame.u - slope_y * scene.frame.v);
    const double off = (p.z - member.surface.height(p.x, p.y)) * dot(normal, scene.frame.w);
    const double share =
        (1 - 0.9 * f.squared_distance / member.area) *
        belonging(squared_norm(scene.nodes.normals[f.index] - normal), off / member.reach) *
        scene.nodes.trust[f.index];
    const double weight = share * scene.nodes.weights[f.index];
    const double height = scene.frame.local(scene.nodes.measured[f.index]).z;
    const double x = p.x / scale;
    const double y = p.y / scale;
    std::size_t k = 0;
    for (int degree = 0; degree <= 4; ++degree) {
      for (int of_y = 0; of_y <= degree; ++of_y, ++k) {
        const double term = weight * std::pow(x, degree - of_y) * std::pow(y, of_y);
        to.normal.at(k) += term;
        if (degree <= 2) to.right.at(k) += height * term;
      }
    }
    to.heights += weight * height * height;
    to.spread += weight * share;
    to.shares += share;
    to.share_squares += share * share;
    to.count += share > 0 ? 1 : 0;
    variance += weight * share * std::pow(pull.height(p.x, p.y), 2);
  }
  return variance;
}

void expect_equal(const WeightedQuadric::Sums& found, const WeightedQuadric::Sums& truth) {
  constexpr double rounding = 1e-12;
  for (std::size_t k = 0; k < truth.normal.size(); ++k) {
    EXPECT_NEAR(found.normal.at(k), truth.normal.at(k), rounding * truth.normal[0]) << k;
  }
  for (std::size_t k = 0; k < truth.right.size(); ++k) {
    EXPECT_NEAR(found.right.at(k), truth.right.at(k), rounding * truth.normal[0]) << k;
  }
  EXPECT_NEAR(found.heights, truth.heights, rounding * truth.heights);
  EXPECT_NEAR(found.spread, truth.spread, rounding * truth.spread);
  EXPECT_NEAR(found.shares, truth.shares, rounding * truth.shares);
  EXPECT_NEAR(found.share_squares, truth.share_squares, rounding * truth.share_squares);
  EXPECT_EQ(found.count, truth.count);
}

// More and more of them, so that what was filled in before is gone on with.
TEST(SheetSamples, SumsAreThoseOfTheirDefinition) {
  const Scene scene(83);
  SheetSamples samples;
  const HeightQuadric pull{{0.4, -0.3, 0.2, 0.1, 0.5, -0.6}};
  for (const double bend : {0.0, 0.3}) {
    samples.start(scene.nodes, scene.frame, scene.found);
    ASSERT_EQ(samples.size(), 83U);
    for (const std::size_t count : {1U, 7U, 8U, 30U, 83U}) {
      const double area = 1.01 * samples.square(count - 1);
      const HeightQuadric surface{{0.01, 0.1, -0.2, bend, -0.5 * bend, 0.2 * bend}};
      const SheetSamples::Membership member{surface, area, 0.2, normal_reach};
      WeightedQuadric sums(std::sqrt(area));
      samples.sum(count, member, sums);
      WeightedQuadric::Sums truth;
      const double variance = sum_up(scene, count, member, pull, sums.scale(), truth);
      expect_equal(sums.sums(), truth);
      EXPECT_NEAR(samples.variance(pull), variance, 1e-12 * variance);
      if (count == samples.size()) {
        EXPECT_LT(truth.count, count);  // one has no normal
      }
    }
  }
}

TEST(SheetSamples, CountsThoseUpToAnArea) {
  const Scene scene(20);
  SheetSamples samples;
  samples.start(scene.nodes, scene.frame, scene.found);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples.count_within(samples.square(i)), i + 1);
    EXPECT_EQ(samples.count_within(std::nextafter(samples.square(i), 0)), i);
  }
}

TEST(SheetSamples, FourSumsOverLanesAreThoseOfEach) {
  Random random(3);
  std::array<Lanes, 8> values;
  for (Lanes& v : values) {
    for (std::size_t l = 0; l < lane_count; ++l) v[l] = random.gaussian();
  }
  std::array<double, 8> sums;
  sum_each(values, sums.data());
  for (std::size_t k = 0; k < sums.size(); ++k) EXPECT_EQ(sums.at(k), sum(values.at(k)));
}

}  // namespace
}  // namespace deburr

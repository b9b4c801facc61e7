// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "landing.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

constexpr double sigma = 0.4;

/// Two faces, z = 0 with x < 0 and x = 0 with z < 0, as points at distances of about 1 with noise,
/// nodes and exact sheets.
struct Bench {
  Sampled truth;
  std::vector<Vec3> measured;
  std::vector<Sheet> sheets;
  std::size_t step = 1;   ///< one of so many nodes is of the even choice
  bool together = false;  ///< whether points land with the others of their node, of which none has
  mutable std::vector<std::uint8_t> lone;  ///< of the last landing; before it, all are
  bool by_edge = false;  ///< whether the others have sheets as well, and all points look at them

  explicit Bench(unsigned seed = 1) {
    Random random(seed);
    for (const Vec3& p : plane_grid(16).points) {
      for (const bool top : {true, false}) {
        const double in = -p.x - random.uniform();
        truth.points.push_back(top ? Vec3{in, p.y, 0} : Vec3{0, p.y, in});
        truth.normals.push_back(top ? Vec3{0, 0, 1} : Vec3{1, 0, 0});
        Sheet sheet;
        sheet.frame = frame_along(truth.points.back(), truth.normals.back());
        sheet.variance = 0.01;
        sheet.radius = 4;
        sheet.valid = true;
        sheets.push_back(sheet);
      }
    }
    measured = with_noise(truth.points, sigma, seed);
  }
  [[nodiscard]] std::size_t size() const { return measured.size(); }
  Shares land(AutomaticResult& result, double max_move = 10, int threads = 1) const {
    const AutomaticInput input{measured, truth.normals, sigma, 1, max_move};
    FittedNodes nodes{std::vector<std::uint32_t>(size()), size(), 1, {}, {}, {}};
    std::iota(nodes.of.begin(), nodes.of.end(), 0U);
    if (together) {
      nodes.measured = measured;
      nodes.places = truth.points;
      nodes.normals = truth.normals;
    }
    result.points = truth.points;
    result.normals = truth.normals;
    result.labels.assign(size(), Feature::Surface);
    NodeSheets fitted;
    for (const bool even : {true, false}) {
      for (std::uint32_t i = 0; i < sheets.size(); ++i) {
        if (!sheets[i].valid || (i % step == 0) != even || !(even || by_edge)) continue;
        fitted.sheets.push_back(sheets[i]);
        fitted.nodes.push_back(i);
        if (even) ++fitted.even;
      }
    }
    const std::vector<std::uint8_t> all(by_edge ? size() : 0, 1);
    Shares shares;
    lone.assign(size(), 1);
    deburr::land(input, nodes, std::move(fitted), {step, 100, all}, lone, result, &shares,
                 {.threads = threads});
    return shares;
  }
};

double off_faces(const Vec3& p) { return std::max(p.x, p.z); }

TEST(Landing, PutsPointsOntoTheSheets) {
  const Bench bench;
  AutomaticResult result;
  bench.land(result);
  for (std::size_t i = 0; i < bench.size(); ++i) {
    EXPECT_NEAR(off_faces(result.points[i]), 0, 1e-9) << i;
    EXPECT_LT(norm(result.points[i] - bench.measured[i]), 5 * sigma);
    const bool face = result.labels[i] == Feature::Surface;
    if (face) {
      EXPECT_LT(std::min(result.points[i].x, result.points[i].z), -0.79) << i;
    }
  }
}

TEST(Landing, SharesEachPointOutAmongTheSheetsNearIt) {
  const Bench bench;
  AutomaticResult result;
  const Shares shares = bench.land(result);
  const std::size_t all = shares.measured.size();
  ASSERT_EQ(shares.places.size(), all);
  ASSERT_EQ(shares.normals.size(), all);
  ASSERT_EQ(shares.trust.size(), all);
  EXPECT_GT(all, bench.size() + 20);
  EXPECT_LT(all, bench.size() + 100);
  std::vector<double> total(bench.size());
  for (std::size_t k = 0; k < all; ++k) {
    const std::size_t i =
        k < bench.size()
            ? k
            : static_cast<std::size_t>(std::ranges::find(bench.measured, shares.measured[k]) -
                                       bench.measured.begin());
    ASSERT_LT(i, bench.size());
    EXPECT_EQ(shares.measured[k], bench.measured[i]);
    EXPECT_NEAR(off_faces(shares.places[k]), 0, 1e-9) << k;
    // The likeliest comes first.
    EXPECT_EQ(shares.trust[k] > 0.5, k < bench.size()) << k;
    EXPECT_GT(shares.trust[k], 0.02);
    total[i] += shares.trust[k];
  }
  for (std::size_t i = 0; i < bench.size(); ++i) {
    EXPECT_NEAR(total[i], 1, 0.0201) << i;  // less is not worth a place
    const double depth = -std::min(bench.measured[i].x, bench.measured[i].z);
    if (depth > 6 * sigma) {
      EXPECT_GT(total[i], 1 - 1e-6) << i;
    }
  }
}

// Sorted to the likelier face, points by the edge are on the outside in the mean.
TEST(Landing, HasNoBiasAtTheEdge) {
  double sorted = 0, shared = 0, count = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const Bench bench(seed);
    AutomaticResult result;
    const Shares shares = bench.land(result);
    for (std::size_t k = 0; k < shares.measured.size(); ++k) {
      const Vec3& x = shares.measured[k];
      if (std::max(-x.x, -x.z) > 1) continue;
      const double height = dot(x, shares.normals[k]) / sigma;
      shared += shares.trust[k] * height;
      if (k < bench.size()) sorted += height;
      count += shares.trust[k];
    }
  }
  EXPECT_GT(sorted / count, 0.15);            // 0.208
  EXPECT_LT(std::abs(shared / count), 0.06);  // 0.020; its standard error is 0.023
}

TEST(Landing, MovesNoPointFartherThanTheBound) {
  const Bench bench;
  AutomaticResult result;
  bench.land(result, 0.1 * sigma);
  double most = 0;
  for (std::size_t i = 0; i < bench.size(); ++i) {
    most = std::max(most, norm(result.points[i] - bench.measured[i]));
  }
  EXPECT_NEAR(most, 0.1 * sigma, 1e-12);
}

TEST(Landing, TellsWhichPointsHaveNoSheetWithinTheBound) {
  Bench bench;
  const std::size_t far = 5;
  bench.measured[far] = bench.truth.points[far] + Vec3{8 * sigma, 0, 8 * sigma};
  AutomaticResult result;
  bench.land(result, 6 * sigma);
  for (std::size_t i = 0; i < bench.size(); ++i) EXPECT_EQ(bench.lone[i], i == far ? 1 : 0) << i;
  for (Sheet& sheet : bench.sheets) sheet.valid = false;
  bench.land(result);
  EXPECT_THAT(bench.lone, testing::Each(1));
}

TEST(Landing, LeavesPointsWithoutAFitWhereTheyWere) {
  Bench bench;
  for (Sheet& sheet : bench.sheets) sheet.valid = false;
  AutomaticResult result;
  const Shares shares = bench.land(result);
  EXPECT_EQ(result.points, bench.truth.points);
  EXPECT_EQ(result.normals, bench.truth.normals);
  EXPECT_EQ(shares.places, bench.truth.points);
  EXPECT_EQ(shares.trust, std::vector<double>(bench.size(), 1.0));
}

// Sheets of a few nodes are enough away from the edge; by it, points look at all.
TEST(Landing, NeedsNoSheetOfEveryNode) {
  for (const bool by_edge : {false, true}) {
    Bench bench;
    bench.step = 3;
    bench.by_edge = by_edge;
    AutomaticResult result;
    const Shares shares = bench.land(result);
    for (std::size_t i = 0; i < bench.size(); ++i) {
      EXPECT_NEAR(off_faces(result.points[i]), 0, 1e-9) << i;
    }
    // Those that may be of both faces are told, and their shares in the other too.
    double near_edge = 0;
    double told = 0;
    for (std::size_t i = 0; i < bench.size(); ++i) {
      const double depth = -std::min(bench.truth.points[i].x, bench.truth.points[i].z);
      if (depth < sigma) {
        ++near_edge;
        told += shares.by_edge[i];
      } else if (depth > 6) {
        EXPECT_EQ(shares.by_edge[i], 0) << i;
      }
    }
    EXPECT_GT(told, 0.8 * near_edge);
    EXPECT_GT(near_edge, 10);
    for (std::size_t k = bench.size(); k < shares.by_edge.size(); ++k) {
      EXPECT_EQ(shares.by_edge[k], 1);
    }
  }
}

TEST(Landing, HasTheSameBitsForAnyThreads) {
  const Bench bench;
  AutomaticResult one;
  AutomaticResult many;
  const Shares first = bench.land(one, 10, 1);
  const Shares second = bench.land(many, 10, 5);
  EXPECT_EQ(one.points, many.points);
  EXPECT_EQ(one.labels, many.labels);
  EXPECT_EQ(first.places, second.places);
  EXPECT_EQ(first.trust, second.trust);
}

TEST(Landing, OfTheOnlyPointOfANodeIsThatOfThePoint) {
  Bench bench;
  AutomaticResult alone;
  const Shares by_itself = bench.land(alone);
  bench.together = true;
  AutomaticResult with_node;
  const Shares together = bench.land(with_node);
  EXPECT_LT(max_difference(with_node.points, alone.points), 1e-12);
  EXPECT_LT(max_difference(with_node.normals, alone.normals), 1e-12);
  EXPECT_EQ(with_node.labels, alone.labels);
  ASSERT_EQ(together.places.size(), by_itself.places.size());
  EXPECT_LT(max_difference(together.places, by_itself.places), 1e-12);
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <ostream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "deburr/metrics.hpp"
#include "deburr/neighborhoods.hpp"
#include "deburr/normals.hpp"
#include "deburr/orientation.hpp"
#include "deburr/synth.hpp"
#include "parallel.hpp"
#include "support/compare.hpp"
#include "support/denoise_laws.hpp"
#include "support/shapes.hpp"

// Neither the number of threads nor the size of the blocks changes a bit, by any method.

namespace deburr {
namespace {

/// Blocks smaller than eight lanes, not a multiple of them, larger than usual, and the whole cloud.
const std::array<Execution, 5> ways{{{.threads = 2},
                                     {.threads = 3, .block = 5},
                                     {.threads = 7, .block = 100},
                                     {.threads = 2, .block = 1100},
                                     {.threads = 1, .block = std::size_t{1} << 40}}};

struct Case {
  const char* name;
  Shape shape;
  double noise;
  double outliers;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class SameBits : public testing::TestWithParam<Case> {
 protected:
  static PointCloud cloud(std::size_t points = 1200) {
    const Case& c = GetParam();
    return synthesize(c.shape, {.points = points,
                                .noise = c.noise,
                                .noise_unit = NoiseUnit::Spacing,
                                .outliers = c.outliers})
        .cloud;
  }
  static void expect_same_by(const DenoiseOptions& options) {
    const PointCloud scan = cloud();
    const DenoiseResult plain = denoise(scan, options, {.threads = 1});
    EXPECT_NE(plain.cloud.points, scan.points);
    for (const Execution& way : ways) {
      SCOPED_TRACE(testing::Message() << way.threads << " threads, blocks of " << way.block);
      const DenoiseResult result = denoise(scan, options, way);
      expect_same_result(result, plain);
      EXPECT_EQ(result.report.noise, plain.report.noise);
      EXPECT_EQ(result.report.spacing, plain.report.spacing);
    }
  }
};

TEST_P(SameBits, OfTheDefaultMethod) { expect_same_by({}); }

TEST_P(SameBits, OfThePublishedMethodInPlace) {
  expect_same_by({.method = Method::Yadav2018, .yadav2018 = {.rounds = 2}});
}

TEST_P(SameBits, OfThePublishedMethodAtOnce) {
  expect_same_by({.method = Method::Yadav2018, .yadav2018 = {.rounds = 2, .in_place = false}});
}

TEST_P(SameBits, OfThePublishedMethodWithNeighbourhoodsFoundAgain) {
  expect_same_by({.method = Method::Yadav2018, .yadav2018 = {.rounds = 2, .rebuild = true}});
}

// More points than a small tree has, so that threads build it.
TEST_P(SameBits, OfNeighboursAndNormals) {
  const std::vector<Vec3> points = cloud(9000).points;
  const Neighborhoods near = find_neighbors(points, {.max_count = 8}, {.threads = 1});
  const std::vector<Vec3> normals =
      orient_normals(points, estimate_normals(points, near, {.threads = 1}), near, {.threads = 1});
  const double spacing = mean_neighbor_distance(points, near, {.threads = 1});
  for (const Execution& way : ways) {
    SCOPED_TRACE(testing::Message() << way.threads << " threads, blocks of " << way.block);
    const Neighborhoods other = find_neighbors(points, {.max_count = 8}, way);
    ASSERT_EQ(other.size(), near.size());
    for (std::size_t i = 0; i < near.size(); ++i) {
      ASSERT_TRUE(std::ranges::equal(other[i], near[i])) << i;
    }
    EXPECT_EQ(orient_normals(points, estimate_normals(points, near, way), near, way), normals);
    EXPECT_EQ(mean_neighbor_distance(points, near, way), spacing);
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds, SameBits,
                         testing::Values(Case{"part", Shape::Part, 0.7, 0},
                                         Case{"torus", Shape::Torus, 1, 0},
                                         Case{"sheet", Shape::BumpySheet, 0.5, 0.05}),
                         [](const auto& c) { return std::string(c.param.name); });

// What is gathered by blocks of 1024 is never touched by two threads, whatever blocks there are.
TEST(ParallelBlocks, CoverEveryItemOnceInTheOrderOfTheirPart) {
  for (const std::size_t block : {0U, 1U, 7U, 1000U, 1024U, 1025U, 5000U, 1U << 30U}) {
    constexpr std::size_t n = 200001;
    std::vector<std::vector<std::size_t>> parts(n / block_size + 1);
    std::vector<std::size_t> last(parts.size());
    parallel_blocks(n, {.threads = 4, .block = block}, [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t>& part = parts[begin / block_size];
      for (std::size_t i = begin; i < end; ++i) part.push_back(i);
    });
    std::size_t next = 0;
    for (const auto& part : parts) {
      for (const std::size_t i : part) ASSERT_EQ(i, next++) << block;
    }
    EXPECT_EQ(next, n) << block;
  }
}

TEST(ParallelBlocks, GiveAllBlocksOfAPartToOneThread) {
  constexpr std::size_t n = 8 * block_size;
  std::array<std::set<std::thread::id>, n / block_size> threads;
  std::mutex lock;
  parallel_blocks(n, {.threads = 4, .block = 100}, [&](std::size_t begin, std::size_t) {
    // Other threads are to have the time to come and take the next block.
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::lock_guard guard(lock);
    threads.at(begin / block_size).insert(std::this_thread::get_id());
  });
  for (const auto& of_part : threads) EXPECT_EQ(of_part.size(), 1U);
}

}  // namespace
}  // namespace deburr

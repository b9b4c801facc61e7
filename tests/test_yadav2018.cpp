// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "deburr/denoise.hpp"
#include "support/compare.hpp"

// Outputs of the authors' program, run unchanged with its default parameters.

namespace deburr {
namespace {

namespace fs = std::filesystem;

/// x y z nx ny nz per line.
PointCloud read(const fs::path& path) {
  std::ifstream file(path);
  PointCloud cloud;
  Vec3 p;
  Vec3 n;
  while (file >> p.x >> p.y >> p.z >> n.x >> n.y >> n.z) {
    cloud.points.push_back(p);
    cloud.normals.push_back(n);
  }
  EXPECT_GT(cloud.size(), 0U) << path;
  return cloud;
}

PointCloud golden(const std::string& name) { return read(fs::path(DEBURR_TEST_DATA) / name); }

DenoiseResult run(const PointCloud& cloud, const Yadav2018Options& options,
                  const Execution& execution = {}) {
  return denoise(cloud,
                 {.method = Method::Yadav2018, .normals = NormalSource::Keep, .yadav2018 = options},
                 execution);
}

double diagonal(Points points) {
  Vec3 low = points.front();
  Vec3 high = low;
  for (const Vec3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return norm(high - low);
}

void expect_equal(const PointCloud& result, const PointCloud& reference, double tolerance) {
  EXPECT_LE(max_difference(result.points, reference.points),
            tolerance * diagonal(reference.points));
  EXPECT_LE(max_difference(result.normals, reference.normals), tolerance);
}

/// Rounding grows from round to round.
double tolerance_after(int rounds) { return rounds == 1 ? 1e-12 : 1e-9; }

void expect_reference(const fs::path& folder, const std::string& name, int rounds) {
  SCOPED_TRACE(name + " after " + std::to_string(rounds) + " rounds");
  const PointCloud input = read(folder / (name + "_init.xyz"));
  const PointCloud reference = read(folder / (name + "_p" + std::to_string(rounds) + ".xyz"));
  expect_equal(run(input, {.rounds = rounds}).cloud, reference, tolerance_after(rounds));
}

TEST(Yadav2018, EqualsTheAuthorsProgramOnABoxOfRandomPoints) {
  expect_reference(DEBURR_TEST_DATA, "blob", 1);
  expect_reference(DEBURR_TEST_DATA, "blob", 50);
}

TEST(Yadav2018, EqualsTheAuthorsProgramOnASphereWithOutliers) {
  expect_reference(DEBURR_TEST_DATA, "outl", 1);
  expect_reference(DEBURR_TEST_DATA, "outl", 50);
}

TEST(Yadav2018, MovesNothingOnAnExactPlane) {
  const PointCloud plane = golden("plane_init.xyz");
  const DenoiseResult result = run(plane, {});
  EXPECT_EQ(result.cloud.points, plane.points);
  EXPECT_EQ(result.cloud.normals, plane.normals);
  EXPECT_THAT(result.displacement, testing::Each(0));
}

/// Every pair NAME_init.xyz, NAME_pK.xyz of a folder that is not part of this repository.
TEST(Yadav2018, EqualsTheAuthorsProgramOnAllReferencePairs) {
  const fs::path folder = fs::path(DEBURR_SOURCE_DIR) / ".." / "shared" / "reference";
  if (!fs::is_directory(folder)) {
    GTEST_SKIP() << "NOT TESTED: the folder of larger reference pairs, " << folder
                 << ", is missing";
  }
  int pairs = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    const std::size_t at = stem.rfind("_p");
    if (entry.path().extension() != ".xyz" || at == std::string::npos) continue;
    expect_reference(folder, stem.substr(0, at), std::stoi(stem.substr(at + 2)));
    ++pairs;
  }
  EXPECT_GT(pairs, 0);
}

TEST(Yadav2018, LeavesPointsWithoutAVoteWhereTheyAre) {
  const PointCloud input = golden("outl_init.xyz");
  const DenoiseResult result = run(input, {});
  std::size_t isolated = 0;
  for (std::size_t i = 0; i < input.size(); ++i) {
    if (result.cloud.normals[i] != Vec3{}) continue;
    EXPECT_EQ(result.labels[i], Feature::Isolated);
    EXPECT_EQ(result.cloud.points[i], input.points[i]);
    ++isolated;
  }
  EXPECT_GE(isolated, 3U);  // the far points
}

TEST(Yadav2018, NeverMovesBeyondEpsilon) {
  const PointCloud input = golden("blob_init.xyz");
  for (const bool in_place : {true, false}) {
    const DenoiseResult result = run(input, {.rounds = 20, .epsilon = 0.7, .in_place = in_place});
    EXPECT_DOUBLE_EQ(result.report.max_move, 0.7 * result.report.spacing);
    const double largest = *std::ranges::max_element(result.displacement);
    EXPECT_LT(largest, result.report.max_move);
    EXPECT_GT(largest, 0.9 * result.report.max_move);
  }
}

TEST(Yadav2018, DiffersWhenAllPointsMoveAtOnce) {
  const PointCloud input = golden("outl_init.xyz");
  const DenoiseResult in_place = run(input, {.rounds = 3});
  const DenoiseResult at_once = run(input, {.rounds = 3, .in_place = false});
  EXPECT_GT(max_difference(in_place.cloud.points, at_once.cloud.points), 1e-6);
  // The normals of the first round do not depend on the positions.
  EXPECT_EQ(run(input, {.rounds = 1}).cloud.normals,
            run(input, {.rounds = 1, .in_place = false}).cloud.normals);
}

TEST(Yadav2018, RebuildsTheNeighbourhoodsFromTheSecondRoundOn) {
  const PointCloud input = golden("blob_init.xyz");
  const auto points = [&](int rounds, bool rebuild) {
    return run(input, {.rounds = rounds, .rebuild = rebuild}).cloud.points;
  };
  EXPECT_EQ(points(1, true), points(1, false));
  EXPECT_NE(points(3, true), points(3, false));
  EXPECT_LT(max_difference(points(3, true), input.points),
            2 * run(input, {.rounds = 0}).report.spacing);
}

// A point sees the new positions of those before it: another order, another result.
TEST(Yadav2018, DependsOnTheOrderOfThePointsOnlyInPlace) {
  const PointCloud input = golden("blob_init.xyz");
  PointCloud reversed = input;
  std::ranges::reverse(reversed.points);
  std::ranges::reverse(reversed.normals);
  for (const bool in_place : {true, false}) {
    const Yadav2018Options options{.rounds = 5, .in_place = in_place};
    std::vector<Vec3> back = run(reversed, options).cloud.points;
    std::ranges::reverse(back);
    EXPECT_EQ(run(input, options).cloud.points == back, !in_place);
  }
}

TEST(Yadav2018, IsTheSameForAnyNumberOfThreads) {
  const PointCloud input = golden("outl_init.xyz");
  for (const bool in_place : {true, false}) {
    const Yadav2018Options options{.rounds = 5, .in_place = in_place};
    const DenoiseResult one = run(input, options, {.threads = 1});
    for (const int threads : {2, 3, 7}) {
      const DenoiseResult other = run(input, options, {.threads = threads});
      EXPECT_EQ(other.cloud.points, one.cloud.points);
      EXPECT_EQ(other.cloud.normals, one.cloud.normals);
      EXPECT_EQ(other.labels, one.labels);
    }
  }
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <string>
#include <thread>

#include "deburr/denoise.hpp"
#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "deburr/orientation.hpp"
#include "deburr/synth.hpp"
#include "parallel.hpp"
#include "support/shapes.hpp"
#include "support/temp_dir.hpp"

// Whoever asks to stop is heard at any place of a run, and files stay as they are.

namespace deburr {
namespace {

constexpr std::array<DenoiseOptions, 3> methods{
    {{},
     {.method = Method::Yadav2018, .yadav2018 = {.rounds = 1}},
     {.method = Method::Yadav2018, .yadav2018 = {.rounds = 1, .in_place = false}}}};

/// As a program does it: reads a file, denoises the cloud and writes it over the file.
void denoise_file(const std::filesystem::path& path, const DenoiseOptions& options,
                  const Execution& execution) {
  DenoiseResult result = denoise(read_cloud(path, execution.cancelled), options, execution);
  (void)write_cloud(path, result.cloud, execution.cancelled);
}

class Cancel : public testing::Test {
 protected:
  void SetUp() override {
    (void)write_cloud(path, synthesize(Shape::Part, {.points = 500}).cloud);
    before = get(path);
  }
  void expect_untouched() const {
    EXPECT_TRUE(get(path) == before);
    EXPECT_EQ(dir.count(), 1);
  }

  TempDir dir;
  std::filesystem::path path = dir / "scan.ply";
  std::string before;
};

TEST_F(Cancel, EndsTheRunFromEveryCallOfProgress) {
  for (const DenoiseOptions& options : methods) {
    int calls = 0;
    int stop_at = 0;
    std::atomic<bool> stop = false;
    // One thread, since several do not tell as often in every run.
    const Execution execution{.threads = 1,
                              .progress = [&](const Progress&) { stop = ++calls == stop_at; },
                              .cancelled = [&] { return stop.load(); }};
    (void)denoise(read_cloud(path), options, execution);
    const int all = calls;
    EXPECT_GT(all, 5);
    for (stop_at = 1; stop_at <= all; ++stop_at) {
      calls = 0;
      stop = false;
      EXPECT_THROW(denoise_file(path, options, execution), Cancelled) << stop_at << " of " << all;
      EXPECT_EQ(calls, stop_at);
      expect_untouched();
    }
  }
}

// Where the other threads are busy with the last blocks, and nobody takes another one.
TEST(CancelBlocks, IsHeardWhileTheLastAreUnderWay) {
  std::atomic<bool> stop = false;
  std::atomic<int> begun = 0;
  int told = 0;
  const auto caller = std::this_thread::get_id();
  const Execution execution{.threads = 2,
                            .progress =
                                [&](const Progress&) {
                                  ++told;
                                  stop = true;
                                },
                            .cancelled = [&] { return stop.load(); }};
  const auto body = [&](std::size_t, std::size_t) {
    // Neither ends before both have begun.
    ++begun;
    while (begun < 2) std::this_thread::yield();
    if (std::this_thread::get_id() != caller) {
      while (!stop) std::this_thread::yield();
    }
  };
  EXPECT_THROW(parallel_blocks(2 * block_size, execution, body), Cancelled);
  EXPECT_EQ(told, 1);
}

// Also between calls of progress. Sorts by several threads ask by chance, so there is one.
TEST_F(Cancel, EndsTheRunWheneverItIsAsked) {
  for (const DenoiseOptions& options : methods) {
    int asked = 0;
    int stop_at = 0;
    const Execution execution{.threads = 1, .cancelled = [&] { return ++asked == stop_at; }};
    const PointCloud cloud = read_cloud(path);
    (void)denoise(cloud, options, execution);
    const int all = asked;
    EXPECT_GT(all, 30);
    for (stop_at = 1; stop_at <= all; stop_at += 1 + all / 20) {
      asked = 0;
      EXPECT_THROW((void)denoise(cloud, options, execution), Cancelled) << stop_at;
      EXPECT_EQ(asked, stop_at);
    }
  }
}

/// How often a run with blocks of so many points asks.
int times_asked(const PointCloud& cloud, const DenoiseOptions& options, std::size_t block) {
  std::atomic<int> asked = 0;
  (void)denoise(cloud, options,
                {.threads = 1, .cancelled = [&] { return ++asked == 0; }, .block = block});
  return asked;
}

TEST_F(Cancel, IsAskedForEveryBlock) {
  const PointCloud cloud = read_cloud(path);
  for (const DenoiseOptions& options : methods) {
    EXPECT_GT(times_asked(cloud, options, 8), 2 * times_asked(cloud, options, 0));
  }
}

// A single tree over all edges, walked and sorted by one thread.
TEST(CancelOrientation, IsAskedAlongTheWay) {
  const std::vector<Vec3> points = random_points(100000, 1);
  const Neighborhoods near = find_neighbors(points, {.max_count = 6});
  const std::vector<Vec3> normals = random_directions(points.size(), 2);
  std::atomic<int> asked = 0;
  std::atomic<int> stop_at = -1;
  const Execution execution{.threads = 1, .cancelled = [&] { return ++asked == stop_at; }};
  (void)orient_normals(points, normals, near, execution);
  const int all = asked;
  // Twice for each block of the graph, the rest by sorting, joining and walking.
  EXPECT_GT(all, 250);
  for (const int at : {all / 2, 3 * all / 4, all}) {
    asked = 0;
    stop_at = at;
    EXPECT_THROW((void)orient_normals(points, normals, near, execution), Cancelled) << at;
  }
}

}  // namespace
}  // namespace deburr

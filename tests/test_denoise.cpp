// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "deburr/denoise.hpp"
#include "deburr/error.hpp"
#include "support/compare.hpp"
#include "support/same_cloud.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

using testing::Each;
using testing::Field;

PointCloud cloud_of(std::vector<Vec3> points, std::vector<Vec3> normals = {}) {
  PointCloud cloud;
  cloud.points = std::move(points);
  cloud.normals = std::move(normals);
  return cloud;
}

PointCloud noisy_cube() { return cloud_of(with_noise(cube(1500, 1).points, 0.04, 2)); }
PointCloud noisy_sphere() { return cloud_of(with_noise(sphere(1500, 3).points, 0.03, 4)); }

constexpr std::array<DenoiseOptions, 2> both_methods{
    {{.method = Method::Auto}, {.method = Method::Yadav2018}}};

double mean_distance(const std::vector<Vec3>& points, double (*distance)(const Vec3&)) {
  return mean_of(points.size(), [&](std::size_t i) { return distance(points[i]); });
}

TEST(Denoise, BringsACubeNearerToTheTruth) {
  const PointCloud cloud = noisy_cube();
  EXPECT_LT(mean_distance(denoise(cloud).cloud.points, distance_to_cube),
            0.5 * mean_distance(cloud.points, distance_to_cube));
}

TEST(Denoise, BringsASphereNearerToTheTruth) {
  const PointCloud cloud = noisy_sphere();
  EXPECT_LT(mean_distance(denoise(cloud).cloud.points, distance_to_sphere),
            0.5 * mean_distance(cloud.points, distance_to_sphere));
}

TEST(Denoise, GivesNormalsOfTheTruth) {
  const Sampled truth = sphere(4000, 5);
  const DenoiseResult result = denoise(cloud_of(with_noise(truth.points, 0.02, 6)));
  EXPECT_LT(
      mean_of(4000,
              [&](std::size_t i) { return angle(result.cloud.normals[i], truth.normals[i]); }),
      8);
}

TEST(Denoise, DoesNothingInNoRounds) {
  const PointCloud cloud = noisy_cube();
  const DenoiseResult result =
      denoise(cloud, {.method = Method::Yadav2018, .yadav2018 = {.rounds = 0}});
  EXPECT_TRUE(same_values(result.cloud.points, cloud.points));
  EXPECT_THAT(result.displacement, Each(0));
  EXPECT_TRUE(result.report.rounds.empty());
  EXPECT_GT(result.report.spacing, 0);
}

TEST(Denoise, NeverMovesBeyondTheBoundOfTheReport) {
  for (const double max_move : {0.0, 0.01, 0.05}) {
    const PointCloud cloud = noisy_cube();
    const DenoiseResult result = denoise(cloud, {.automatic = {.max_move = max_move}});
    const double bound = max_move > 0 ? max_move : 4 * result.report.noise;
    EXPECT_NEAR(result.report.max_move, bound, 1e-12);
    const double largest = *std::ranges::max_element(result.displacement);
    EXPECT_GT(largest, 0);
    EXPECT_LE(largest, result.report.max_move * (1 + 1e-12));
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      ASSERT_NEAR(result.displacement[i], norm(result.cloud.points[i] - cloud.points[i]), 1e-14);
    }
  }
}

TEST(Denoise, LeavesAttributesAndLayoutAlone) {
  PointCloud cloud = noisy_cube();
  cloud.attributes.push_back({"intensity", std::vector<float>(1500, 0.5F), {}});
  cloud.attributes.push_back({"name", std::vector<std::string>(1500, "a b"), {}});
  cloud.layout.encoding = Encoding::PlyBigEndian;
  cloud.layout.comments = {"scanned today"};
  cloud.layout.fields = {{"x", ScalarType::Float32}, {"intensity", ScalarType::Float32}};
  cloud.layout.elements.push_back({"face", 0, {}, true});
  for (const DenoiseOptions& options : both_methods) {
    DenoiseResult result = denoise(cloud, options);
    EXPECT_NE(result.cloud.points, cloud.points);
    result.cloud.points = cloud.points;
    result.cloud.normals = cloud.normals;
    expect_same(result.cloud, cloud);
  }
}

TEST(Denoise, CountsWhatItReports) {
  PointCloud cloud = noisy_sphere();
  cloud.points.insert(cloud.points.end(), 3, cloud.points[0]);
  cloud.points.push_back({std::nan(""), 0, 0});
  for (const DenoiseOptions& options : both_methods) {
    const DenoiseResult result = denoise(cloud, options);
    const Report& report = result.report;
    EXPECT_EQ(report.points, 1504U);
    EXPECT_EQ(report.duplicates, 3U);
    EXPECT_EQ(report.non_finite, 1U);
    EXPECT_EQ(std::accumulate(report.labels.begin(), report.labels.end(), std::size_t{0}), 1504U);
    for (std::size_t label = 0; label < 4; ++label) {
      EXPECT_EQ(report.labels.at(label),
                std::ranges::count(result.labels, static_cast<Feature>(label)));
    }
    EXPECT_NEAR(report.spacing, std::sqrt(12.57 / 1500), 0.7 * std::sqrt(12.57 / 1500));
    EXPECT_NEAR(report.noise, 0.03, 0.009);
  }
}

TEST(Denoise, ReportsEveryRoundOfThePublishedMethod) {
  DenoiseOptions options{.method = Method::Yadav2018, .yadav2018 = {.rounds = 3}};
  const DenoiseResult result = denoise(noisy_sphere(), options);
  ASSERT_EQ(result.report.rounds.size(), 3U);
  for (const RoundReport& round : result.report.rounds) {
    EXPECT_GT(round.rms_move, 0);
    EXPECT_GT(round.max_move, round.rms_move);
  }
  options.yadav2018.rounds = 1;
  const DenoiseResult first = denoise(noisy_sphere(), options);
  EXPECT_NEAR(first.report.rounds[0].max_move, *std::ranges::max_element(first.displacement),
              1e-12);
  const double mean_square =
      mean_of(1500, [&](std::size_t i) { return first.displacement[i] * first.displacement[i]; });
  EXPECT_NEAR(first.report.rounds[0].rms_move, std::sqrt(mean_square), 1e-12);
}

TEST(Denoise, TakesNormalsFromWhereItIsTold) {
  const Sampled truth = sphere(1000, 7);
  const auto kept = [&](NormalSource source, const std::vector<Vec3>& normals) {
    return denoise(cloud_of(truth.points, normals), {.normals = source}).report.kept_normals;
  };
  EXPECT_TRUE(kept(NormalSource::Auto, truth.normals));
  EXPECT_TRUE(kept(NormalSource::Keep, truth.normals));
  EXPECT_FALSE(kept(NormalSource::Estimate, truth.normals));
  EXPECT_FALSE(kept(NormalSource::Auto, {}));
  EXPECT_FALSE(kept(NormalSource::Estimate, {}));
  EXPECT_THROW((void)kept(NormalSource::Keep, {}), DataError);
  // Those that are not wanted do not matter.
  EXPECT_EQ(denoise(cloud_of(truth.points, random_directions(1000, 8)),
                    {.normals = NormalSource::Estimate})
                .cloud.points,
            denoise(cloud_of(truth.points)).cloud.points);
}

TEST(Denoise, TellsProgressOnTheCallersThread) {
  // By points, by nodes of several, and with noise that is not the same everywhere.
  const std::vector<Vec3> points = sphere(600, 3).points;
  const auto scan = [&](double noise) { return cloud_of(with_noise(points, noise, 4)); };
  std::vector<Vec3> two = with_noise(points, 0.01, 5);
  for (const Vec3& p : with_noise(points, 0.07, 6)) two.push_back(p + Vec3{4, 0, 0});
  const std::array scans{scan(0.01), scan(0.03), scan(0.1), cloud_of(two)};
  for (std::size_t k = 0; k <= scans.size(); ++k) {
    const DenoiseOptions options{.method = k > 0 ? Method::Auto : Method::Yadav2018};
    std::vector<double> told{0};
    const Execution execution{.threads = 2,
                              .progress =
                                  [&, me = std::this_thread::get_id()](const Progress& progress) {
                                    EXPECT_EQ(std::this_thread::get_id(), me);
                                    EXPECT_GE(progress.fraction, told.back()) << progress.stage;
                                    EXPECT_FALSE(progress.stage.empty());
                                    told.push_back(progress.fraction);
                                  },
                              .block = 20};
    (void)denoise(scans[k % scans.size()], options, execution);
    EXPECT_GT(told.size(), 10U);
    EXPECT_GT(told.back(), 0.95);
    EXPECT_LE(told.back(), 1 + 1e-12);
  }
}

TEST(Denoise, LetsProgressStopTheWork) {
  struct Stop {};
  int calls = 0;
  const Execution execution{.progress = [&](const Progress&) {
    if (++calls == 3) throw Stop{};
  }};
  EXPECT_THROW((void)denoise(noisy_sphere(), {}, execution), Stop);
  EXPECT_EQ(calls, 3);
}

TEST(Denoise, StopsWhenCancelled) {
  for (const DenoiseOptions& options : both_methods) {
    std::atomic<int> asked = 0;
    std::atomic<int> allowed = -1;
    const Execution execution{.threads = 2, .cancelled = [&] { return asked++ == allowed; }};
    (void)denoise(noisy_sphere(), options, execution);
    const int total = asked;  // about: how often a parallel sort asks is a matter of chance
    EXPECT_GT(total, 30);
    for (const int at : {0, 1, total / 4, total / 2, 3 * total / 4}) {
      asked = 0;
      allowed = at;
      EXPECT_THROW((void)denoise(noisy_sphere(), options, execution), Cancelled) << at;
    }
  }
}

TEST(Denoise, TimesItsStagesByTheClockOfTheCaller) {
  double now = 100;
  const Execution execution{.clock = [&] { return now += 0.5; }};
  for (const DenoiseOptions& options : both_methods) {
    const double start = now;
    const DenoiseResult timed = denoise(noisy_sphere(), options, execution);
    const DenoiseResult untimed = denoise(noisy_sphere(), options);
    std::set<std::string_view> names;
    double total = 0;
    for (const StageTime& stage : timed.report.stages) {
      EXPECT_GE(stage.seconds, 0.5) << stage.stage;
      total += stage.seconds;
      names.insert(stage.stage);
    }
    EXPECT_GT(names.size(), 4U);
    EXPECT_EQ(names.size(), timed.report.stages.size());
    EXPECT_LE(total, now - start);
    EXPECT_THAT(untimed.report.stages, Each(Field(&StageTime::seconds, 0)));
    EXPECT_EQ(untimed.cloud.points, timed.cloud.points);
  }
}

}  // namespace
}  // namespace deburr

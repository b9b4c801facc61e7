// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "deburr/denoise.hpp"
#include "deburr/io.hpp"
#include "deburr/metrics.hpp"
#include "deburr/synth.hpp"
#include "deburr/version.hpp"
#include "run_program.hpp"

// What the commands do when all is well.

namespace deburr::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

PointCloud part(std::size_t points) { return synthesize_part({.points = points}).cloud; }

template <typename T>
std::vector<T> values_of(const PointCloud& cloud, const std::string& name) {
  for (const Attribute& attribute : cloud.attributes) {
    if (attribute.name == name) return std::get<std::vector<T>>(attribute.values);
  }
  return {};
}

TEST_F(CliTest, DenoiseWritesWhatTheLibraryReturns) {
  const PointCloud cloud = part(2000);
  write_cloud("in.ply", cloud);
  const Outcome outcome = run_program({"denoise", "in.ply", "out.ply"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, IsEmpty());
  EXPECT_THAT(outcome.err, HasSubstr("in.ply: 2000 points, spacing"));
  EXPECT_THAT(
      outcome.err,
      HasSubstr("2000 points written to out.ply with nx ny nz deburr_label deburr_displacement "
                "deburr_outlier"));

  const DenoiseResult expected = denoise(cloud);
  const PointCloud written = read_cloud("out.ply");
  EXPECT_TRUE(written.points == expected.cloud.points);
  EXPECT_TRUE(written.normals == expected.cloud.normals);
  const auto labels = values_of<std::uint8_t>(written, "deburr_label");
  const auto moved = values_of<float>(written, "deburr_displacement");
  ASSERT_EQ(labels.size(), cloud.size());
  ASSERT_EQ(moved.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(labels[i], static_cast<std::uint8_t>(expected.labels[i]));
    ASSERT_EQ(moved[i], static_cast<float>(expected.displacement[i]));
  }
}

TEST_F(CliTest, DenoiseHandsEveryOptionOn) {
  const PointCloud cloud = part(600);
  write_cloud("in.ply", cloud);
  ASSERT_EQ(run_program(
                {"denoise",     "in.ply",    "out.ply", "--method",        "yadav2018", "--rounds",
                 "3",           "--k",       "9",       "--rho",           "0.8",       "--tau",
                 "0.3",         "--damping", "2",       "--alpha",         "0.2",       "--epsilon",
                 "1.5",         "--radius",  "1.75",    "--neighborhoods", "per-round", "--update",
                 "simultaneous"})
                .exit_code,
            0);
  const DenoiseOptions options{.method = Method::Yadav2018,
                               .automatic = {},
                               .yadav2018 = {.k = 9,
                                             .rounds = 3,
                                             .rho = 0.8,
                                             .tau = 0.3,
                                             .damping = 2,
                                             .alpha = 0.2,
                                             .epsilon = 1.5,
                                             .radius = 1.75,
                                             .rebuild = true,
                                             .in_place = false}};
  EXPECT_TRUE(read_cloud("out.ply").points == denoise(cloud, options).cloud.points);
}

TEST_F(CliTest, DenoiseHandsTheOptionsOfTheDefaultMethodOn) {
  const PointCloud cloud =
      synthesize_part({.points = 1500, .noise = 0.004, .outliers = 0.05}).cloud;
  write_cloud("in.ply", cloud);
  const Outcome outcome =
      run_program({"denoise", "in.ply", "out.ply", "--strength", "4", "--max-move", "0.75",
                   "--noise", "0.4", "--outliers", "remove", "--report", "report.json"});
  ASSERT_EQ(outcome.exit_code, 0);
  const DenoiseOptions options{
      .automatic = {
          .strength = 4, .noise = 0.4, .max_move = 0.75, .outliers = OutlierAction::Remove}};
  const DenoiseResult expected = denoise(cloud, options);
  EXPECT_TRUE(read_cloud("out.ply").points == expected.cloud.points);
  EXPECT_GT(expected.report.outliers, 10U);
  EXPECT_EQ(expected.cloud.size(), cloud.size() - expected.report.outliers);
  const json summary = json::parse(read_text("report.json"));
  EXPECT_EQ(summary["points"], cloud.size());
  EXPECT_EQ(summary["kept"], expected.cloud.size());
  EXPECT_THAT(outcome.err,
              HasSubstr(std::to_string(expected.cloud.size()) + " points written to out.ply"));
}

TEST_F(CliTest, DenoiseGivesTheSameBytesForAnyNumberOfThreads) {
  write_cloud("in.ply", part(3000));
  ASSERT_EQ(run_program({"denoise", "in.ply", "one.ply", "--threads", "1"}).exit_code, 0);
  ASSERT_EQ(run_program({"denoise", "in.ply", "three.ply", "--threads", "3"}).exit_code, 0);
  EXPECT_EQ(read_text("one.ply"), read_text("three.ply"));
}

// Published positions and normals in, the same columns out.
TEST_F(CliTest, DenoiseReproducesThePublishedProgram) {
  const std::filesystem::path golden = DEBURR_TEST_DATA;
  ASSERT_EQ(run_program({"denoise", golden / "blob_init.xyz", "out.xyz", "--method", "yadav2018",
                         "--rounds", "1", "--normals", "keep"})
                .exit_code,
            0);
  EXPECT_EQ(lines_of(read_text("out.xyz")).size(),
            lines_of(read_text(golden / "blob_p1.xyz")).size());
  const PointCloud written = read_cloud("out.xyz");
  const PointCloud expected = read_cloud(golden / "blob_p1.xyz");
  EXPECT_THAT(written.attributes, IsEmpty());
  ASSERT_EQ(written.size(), expected.size());
  ASSERT_EQ(written.normals.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_LT(norm(written.points[i] - expected.points[i]), 1e-12) << i;
    EXPECT_LT(norm(written.normals[i] - expected.normals[i]), 1e-12) << i;
  }
}

TEST_F(CliTest, DenoiseTellsItsSummaryAsJson) {
  PointCloud cloud = part(500);
  cloud.points[3] = cloud.points[2];
  cloud.points[7].x = std::nan("");
  write_cloud("in.ply", cloud);
  const Outcome outcome =
      run_program({"denoise", "in.ply", "out.ply", "--json", "--report", "report.json"});
  ASSERT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, IsEmpty());
  EXPECT_EQ(outcome.out, read_text("report.json"));

  const json summary = json::parse(outcome.out);
  const DenoiseResult expected = denoise(cloud);
  EXPECT_EQ(summary["deburr_version"], version);
  EXPECT_EQ(summary["points"], 500);
  EXPECT_EQ(summary["non_finite"], 1);
  EXPECT_EQ(summary["duplicates"], 1);
  EXPECT_EQ(summary["spacing"], expected.report.spacing);
  EXPECT_EQ(summary["noise"], expected.report.noise);
  EXPECT_EQ(summary["rounds"].size(), expected.report.rounds.size());
  EXPECT_EQ(summary["labels"]["surface"], expected.report.labels[0]);
  EXPECT_EQ(summary["options"]["method"], "auto");
  EXPECT_EQ(summary["outliers"], expected.report.outliers);
  EXPECT_EQ(summary["kept"], 500);
  EXPECT_EQ(summary["options"]["strength"], AutoOptions{}.strength);
  EXPECT_EQ(summary["options"]["max_move"], AutoOptions{}.max_move);
  EXPECT_EQ(summary["options"]["noise"], AutoOptions{}.noise);
  EXPECT_EQ(summary["options"]["outliers"], "label");
  double squares = 0;
  for (const double moved : expected.displacement) squares += moved * moved;
  const double rms = std::sqrt(squares / 499);  // summed in another order
  EXPECT_NEAR(summary["rms_displacement"].get<double>(), rms, 1e-13 * rms);
  EXPECT_EQ(summary["max_displacement"], std::ranges::max(expected.displacement));
  double seconds = 0;
  for (const json& stage : summary["stages"]) seconds += stage["seconds"].get<double>();
  EXPECT_GT(seconds, 0);
}

TEST_F(CliTest, QuietPrintsNothing) {
  for (const std::vector<std::string>& args :
       {std::vector<std::string>{"synth", "part", "in.ply", "--points", "300", "--quiet"},
        {"denoise", "in.ply", "out.ply", "--quiet"}}) {
    const Outcome outcome = run_program(args);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out + outcome.err, "");
  }
}

TEST_F(CliTest, CloudsWithoutAFinitePointAreWrittenUnchanged) {
  PointCloud cloud;
  write_cloud("empty.ply", cloud);
  cloud.points.assign(3, Vec3{1, std::nan(""), 2});
  write_cloud("nan.ply", cloud);
  for (const std::string name : {"empty.ply", "nan.ply"}) {
    const Outcome outcome = run_program({"denoise", name, "out.ply"});
    EXPECT_THAT(outcome.err, HasSubstr(name == "nan.ply" ? "\n3 points written" : "\n0 points"));
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.err, HasSubstr("warning: " + name + ": no point is finite"));
    EXPECT_EQ(read_text("out.ply"), read_text(name));
  }
}

TEST_F(CliTest, SynthAndCompareAgreeWithTheLibrary) {
  ASSERT_EQ(run_program({"synth", "part", "part.ply", "--points", "700", "--noise", "0.01",
                         "--seed", "5", "--truth", "truth.ply"})
                .exit_code,
            0);
  const SyntheticScan scan = synthesize_part({.points = 700, .noise = 0.01, .seed = 5});
  EXPECT_TRUE(read_cloud("part.ply").points == scan.cloud.points);

  const Outcome outcome = run_program({"compare", "part.ply", "--truth", "truth.ply", "--json"});
  ASSERT_EQ(outcome.exit_code, 0);
  const json result = json::parse(outcome.out);
  const SurfaceError expected = compare_to_surface(scan.cloud.points, scan.truth);
  EXPECT_EQ(result["count"], 700);
  EXPECT_EQ(result["non_finite"], 0);
  EXPECT_DOUBLE_EQ(result["mean"], expected.mean);
  EXPECT_DOUBLE_EQ(result["rms"], expected.rms);
  EXPECT_DOUBLE_EQ(result["maximum"], expected.maximum);
  EXPECT_DOUBLE_EQ(result["rms_relative"], expected.rms / expected.diagonal);
  EXPECT_THAT(run_program({"compare", "part.ply", "--truth", "truth.ply"}).out,
              HasSubstr("% of the diagonal"));
}

}  // namespace
}  // namespace deburr::cli

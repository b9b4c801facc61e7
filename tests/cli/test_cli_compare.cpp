// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "deburr/clean_metrics.hpp"
#include "deburr/cloud_metrics.hpp"
#include "deburr/feature_metrics.hpp"
#include "deburr/io.hpp"
#include "deburr/normal_metrics.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// The figures of `deburr compare` are those of the library, for what the files hold.

namespace deburr::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

template <typename Value>
void add_field(PointCloud& cloud, const std::string& name, std::vector<Value> values) {
  cloud.attributes.push_back({name, std::move(values), {}});
}

/// A scan of the part with a normal for every point, and the surface.
class CliCompare : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    const SyntheticScan scan = synthesize_part({.points = 3000});
    cloud_ = scan.cloud;
    truth_ = scan.truth;
    clean_ = synthesize_part({.points = 3000, .noise = 0}).cloud;
    cloud_.normals.assign(3000, Vec3{0, 0, 1});
    clean_.normals.assign(3000, Vec3{0, 0.6, 0.8});
    write_mesh("truth.ply", truth_);
    write_cloud("clean.ply", clean_);
  }

  /// What the program says about cloud_.
  json figures(std::vector<std::string> more) {
    write_cloud("cloud.ply", cloud_);
    std::vector<std::string> args{"compare", "cloud.ply", "--json", "--truth"};
    args.insert(args.end(), more.begin(), more.end());
    const Outcome outcome = run_program(args);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty());
    return json::parse(outcome.out);
  }

  PointCloud cloud_;
  PointCloud clean_;
  TriangleMesh truth_;
};

TEST_F(CliCompare, TellsDistancesCoverageAndNormalsOfAMesh) {
  const json result = figures({"truth.ply", "--samples", "2000", "--seed", "9"});
  const DistanceError error = compare_to_surface(cloud_.points, truth_);
  EXPECT_EQ(result["truth_kind"], "mesh");
  EXPECT_EQ(result["percentile_95"], error.percentile_95);
  EXPECT_EQ(result["percentile_95_relative"], error.percentile_95 / error.diagonal);
  const DistanceError coverage =
      surface_coverage(cloud_.points, truth_, {.samples = 2000, .seed = 9});
  EXPECT_EQ(result["coverage_count"], 2000);
  EXPECT_EQ(result["coverage_mean"], coverage.mean);
  EXPECT_EQ(result["coverage_percentile_95"], coverage.percentile_95);
  EXPECT_EQ(result["coverage_mean_relative"], coverage.mean / error.diagonal);
  const NormalError normals = normal_error(cloud_.points, cloud_.normals, truth_);
  EXPECT_EQ(result["normal_count"], 3000);
  EXPECT_EQ(result["normal_error"], normals.unoriented);
  EXPECT_EQ(result["normal_error_oriented"], normals.oriented);
  EXPECT_EQ(result["spacing"], mean_spacing(truth_, 3000));
  EXPECT_FALSE(result.contains("chamfer"));
}

TEST_F(CliCompare, LeavesOutWhatCannotBeTold) {
  cloud_.normals.clear();
  const json result = figures({"truth.ply", "--samples", "0"});
  for (const char* key : {"normal_error", "coverage_mean", "edge_precision", "outlier_recall",
                          "offset_mean", "chamfer"}) {
    EXPECT_FALSE(result.contains(key)) << key;
  }
  EXPECT_TRUE(result.contains("edge_mean"));  // needs no labels
  write_mesh("flat.ply", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  EXPECT_FALSE(figures({"flat.ply"}).contains("edge_mean"));
}

TEST_F(CliCompare, JudgesLabelsWhateverTypeTheyHave) {
  std::vector<Feature> labels;
  std::vector<std::uint8_t> numbers;
  for (std::size_t i = 0; i < 3000; ++i) {
    numbers.push_back(static_cast<std::uint8_t>(
        i % 7 < 4 ? i % 7 : i % 7 + 200));  // those over 3 stand for nothing
    labels.push_back(i % 7 < 4 ? static_cast<Feature>(i % 7) : Feature::Surface);
  }
  const double spacing = mean_spacing(truth_, 3000);
  const SharpFeatures sharp = find_sharp_features(truth_);
  const FeatureScore score = score_features(cloud_.points, labels, sharp, spacing);
  const DistanceError zone = edge_error(cloud_.points, truth_, sharp, spacing);
  add_field(cloud_, "deburr_label", numbers);
  for (int type = 0; type < 2; ++type) {
    const json result = figures({"truth.ply"});
    EXPECT_EQ(result["sharp_edges"], sharp.edges.size());
    EXPECT_EQ(result["sharp_corners"], 12);
    EXPECT_EQ(result["edge_precision"], score.edge_precision);
    EXPECT_EQ(result["edge_recall"], score.edge_recall);
    EXPECT_EQ(result["edge_point_recall"], score.edge_point_recall);
    EXPECT_EQ(result["corner_precision"], score.corner_precision);
    EXPECT_EQ(result["corner_recall"], score.corner_recall);
    EXPECT_EQ(result["edge_count"], zone.count);
    EXPECT_EQ(result["edge_mean"], zone.mean);
    EXPECT_EQ(result["edge_mean_ratio"],
              zone.mean / compare_to_surface(cloud_.points, truth_).mean);
    cloud_.attributes.clear();
    add_field(cloud_, "deburr_label", std::vector<double>(numbers.begin(), numbers.end()));
  }
}

TEST_F(CliCompare, TakesACloudAsTruth) {
  const json result = figures({"clean.ply"});
  const CloudError error = compare_to_cloud(cloud_.points, clean_.points);
  EXPECT_EQ(result["truth_kind"], "cloud");
  EXPECT_EQ(result["mean"], error.to_truth.mean);
  EXPECT_EQ(result["rms"], error.to_truth.rms);
  EXPECT_EQ(result["maximum"], error.to_truth.maximum);
  EXPECT_EQ(result["coverage_mean"], error.coverage.mean);
  EXPECT_EQ(result["chamfer"], error.chamfer);
  // (0, 0, 1) and (0, 0.6, 0.8), wherever they are.
  EXPECT_NEAR(result["normal_error_oriented"], std::acos(0.8) * 180 / std::numbers::pi, 1e-10);
  write_cloud("clean.xyz", PointCloud{clean_.points, {}, {}, {}});
  EXPECT_EQ(figures({"clean.xyz"})["chamfer"], error.chamfer);
  EXPECT_FALSE(figures({"clean.xyz"}).contains("normal_error"));
}

TEST_F(CliCompare, ComparesWithTheSamePointsWithoutNoise) {
  std::vector<std::uint8_t> outliers(3000);
  std::vector<std::uint8_t> flags(3000);
  std::vector<Vec3> normals = clean_.normals;
  for (std::size_t i = 0; i < 3000; i += 10) {
    outliers[i] = 1;
    normals[i] = {};  // they have no offset
    cloud_.points[i] += Vec3{500, 0, 0};
    flags[i + (i % 100 == 0 ? 1 : 0)] = 1;
  }
  add_field(clean_, "outlier", outliers);
  write_cloud("clean.ply", clean_);
  json result = figures({"truth.ply", "--clean", "clean.ply"});
  EXPECT_FALSE(result.contains("outlier_recall"));
  const OffsetError offset =
      offset_error(cloud_.points, clean_.points, normals, 1.5 * mean_spacing(truth_, 3000));
  EXPECT_EQ(result["offset_count"], 2700);
  EXPECT_EQ(result["offset_mean"], offset.mean);
  EXPECT_EQ(result["offset_rms"], offset.rms);
  EXPECT_EQ(result["offset_far_share"], offset.far_share);

  add_field(cloud_, "deburr_outlier", flags);
  result = figures({"truth.ply", "--clean", "clean.ply"});
  EXPECT_EQ(result["outlier_count"], 300);
  EXPECT_EQ(result["outlier_flagged"], 300);
  EXPECT_DOUBLE_EQ(result["outlier_recall"], 0.9);
  EXPECT_DOUBLE_EQ(result["outlier_precision"], 0.9);
  EXPECT_FALSE(figures({"clean.ply", "--clean", "clean.ply"}).contains("offset_far_share"));
}

TEST_F(CliCompare, SkipsWhatTheCloudItselfCallsAnOutlier) {
  std::vector<std::uint8_t> flags(3000);
  std::vector<std::uint8_t> labels(3000);
  PointCloud rest;
  std::vector<Vec3> clean_rest;
  for (std::size_t i = 0; i < 3000; ++i) {
    flags[i] = i % 3 == 0 ? 2 : 0;
    labels[i] = i % 2 == 0 ? 1 : 0;
    if (i % 3 == 0) cloud_.points[i] += Vec3{500, 0, 0};
    if (i % 3 == 0) continue;
    rest.points.push_back(cloud_.points[i]);
    rest.normals.push_back(cloud_.normals[i]);
    clean_rest.push_back(clean_.points[i]);
  }
  add_field(cloud_, "deburr_outlier", flags);
  add_field(cloud_, "deburr_label", labels);
  EXPECT_EQ(figures({"truth.ply"})["count"], 3000);
  EXPECT_GT(figures({"truth.ply"})["maximum"], 400);

  const json result = figures({"truth.ply", "--skip-outliers", "--clean", "clean.ply"});
  EXPECT_EQ(result["count"], 2000);
  EXPECT_EQ(result["skipped_outliers"], 1000);
  EXPECT_EQ(result["mean"], compare_to_surface(rest.points, truth_).mean);
  EXPECT_EQ(result["spacing"], mean_spacing(truth_, 2000));
  EXPECT_EQ(result["normal_error"], normal_error(rest.points, rest.normals, truth_).unoriented);
  EXPECT_EQ(result["edge_labels"], 1000);
  EXPECT_EQ(result["offset_mean"],
            offset_error(rest.points, clean_rest, std::vector<Vec3>(2000, {0, 0.6, 0.8}), 1).mean);
}

TEST_F(CliCompare, WritesTheDistanceOfEveryPoint) {
  add_field(cloud_, "deburr_distance", std::vector<float>(3000, 7));
  const auto distances = [](const std::string& file) {
    const std::vector<Attribute> fields = read_cloud(file).attributes;
    EXPECT_EQ(fields.size(), 1U);
    return std::get<std::vector<double>>(fields.at(0).values);
  };
  EXPECT_EQ(figures({"truth.ply", "--distances", "far.ply"})["count"], 3000);
  EXPECT_EQ(read_cloud("far.ply").points, cloud_.points);
  EXPECT_EQ(distances("far.ply"), distance_to_surface(cloud_.points, truth_));
  (void)figures({"clean.ply", "--distances", "far.ply"});
  EXPECT_EQ(distances("far.ply"), distance_to_cloud(cloud_.points, clean_.points));
  // Text has no types: names in a first line tell which column it is.
  (void)figures({"truth.ply", "--distances", "far.csv"});
  EXPECT_THAT(read_text("far.csv"), HasSubstr("deburr_distance"));
  EXPECT_EQ(
      run_program({"compare", "cloud.ply", "--truth", "truth.ply", "--distances", "truth.ply"})
          .exit_code,
      2);
}

TEST_F(CliCompare, WarnsOfWhatWasAskedForAndIsNotThere) {
  write_cloud("cloud.ply", cloud_);
  write_cloud("short.ply", synthesize_part({.points = 10}).cloud);
  const std::vector<std::string> start{"compare", "cloud.ply", "--truth", "truth.ply"};
  const auto warning = [&](std::vector<std::string> more) {
    more.insert(more.begin(), start.begin(), start.end());
    const Outcome outcome = run_program(more);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("mean"));
    return outcome.err;
  };
  EXPECT_THAT(warning({"--clean", "short.ply"}),
              HasSubstr("warning: --clean has 10 points, the cloud 3000"));
  EXPECT_THAT(warning({"--skip-outliers"}), HasSubstr("warning: no field deburr_outlier"));
  cloud_.normals.clear();
  write_cloud("bare.ply", cloud_);
  EXPECT_THAT(warning({"--clean", "bare.ply"}), HasSubstr("warning: --clean has no normals"));
  EXPECT_THAT(warning({"--clean", "bare.ply", "--quiet"}), IsEmpty());
  EXPECT_EQ(figures({"truth.ply", "--clean", "short.ply"})["warnings"].size(), 1U);
}

}  // namespace
}  // namespace deburr::cli

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// The command synth: what it writes, what it tells, what it refuses.

namespace deburr::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

class CliSynth : public CliTest {};

Outcome synth(std::vector<std::string> args) {
  args.insert(args.begin(), "synth");
  return run_program(args);
}

void expect_usage_error(const std::vector<std::string>& args, const std::string& what) {
  const Outcome outcome = synth(args);
  EXPECT_EQ(outcome.exit_code, 2) << what;
  EXPECT_THAT(outcome.err, StartsWith("deburr: "));
  EXPECT_THAT(outcome.err, HasSubstr(what));
  EXPECT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_FALSE(std::filesystem::exists("out.ply"));
}

TEST_F(CliSynth, KnowsEveryShape) {
  const std::vector<std::pair<std::string, Shape>> shapes{{"part", Shape::Part},
                                                          {"cube", Shape::Cube},
                                                          {"sphere", Shape::Sphere},
                                                          {"torus", Shape::Torus},
                                                          {"cylinder", Shape::Cylinder},
                                                          {"thin-plate", Shape::ThinPlate},
                                                          {"bumpy-sheet", Shape::BumpySheet},
                                                          {"stepped-wall", Shape::SteppedWall}};
  for (const auto& [word, shape] : shapes) {
    const Outcome outcome = synth({word, "out.ply", "--points", "50", "--truth", "truth.ply"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(read_cloud("out.ply").points == synthesize(shape, {.points = 50}).cloud.points);
    EXPECT_EQ(read_mesh("truth.ply").triangles, shape_mesh(shape).triangles) << word;
  }
}

TEST_F(CliSynth, EveryOptionArrives) {
  const Outcome outcome =
      synth({"thin-plate",   "out.ply",   "--points",   "400",  "--noise-spacings",   "0.25",
             "--noise-kind", "ray",       "--outliers", "0.05", "--cluster-outliers", "0.1",
             "--sampling",   "poisson",   "--seed",     "7",    "--thickness",        "0.1",
             "--clean",      "clean.ply", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const SyntheticScan scan = synthesize(Shape::ThinPlate, {.points = 400,
                                                           .noise = 0.25,
                                                           .noise_unit = NoiseUnit::Spacing,
                                                           .noise_kind = NoiseKind::Ray,
                                                           .sampling = Sampling::Poisson,
                                                           .outliers = 0.05,
                                                           .cluster_outliers = 0.1,
                                                           .seed = 7,
                                                           .shape = {.thickness = 0.1}});
  EXPECT_TRUE(read_cloud("out.ply").points == scan.cloud.points);
  const json summary = json::parse(outcome.out);
  EXPECT_EQ(summary["shape"], "thin-plate");
  EXPECT_EQ(summary["points"], 460);
  EXPECT_EQ(summary["surface_points"], 400);
  EXPECT_EQ(summary["outlier_points"], 60);
  EXPECT_EQ(summary["noise"], 0.25);
  EXPECT_EQ(summary["noise_unit"], "spacing");
  EXPECT_EQ(summary["noise_kind"], "ray");
  EXPECT_EQ(summary["sampling"], "poisson");
  EXPECT_EQ(summary["outliers"], 0.05);
  EXPECT_EQ(summary["cluster_outliers"], 0.1);
  EXPECT_EQ(summary["seed"], 7);
  EXPECT_EQ(summary["thickness"], 0.1);
  EXPECT_EQ(summary["spacing"], scan.spacing);
  EXPECT_EQ(summary["sigma"], scan.sigma);
  EXPECT_EQ(summary["clean"], "clean.ply");
  EXPECT_TRUE(summary["truth"].is_null());
}

// What would give the answer away stands in a file of its own.
TEST_F(CliSynth, TheTruthOfThePointsIsNotInTheScan) {
  ASSERT_EQ(synth({"cube", "out.ply", "--points", "200", "--outliers", "0.1", "--clean",
                   "clean.ply", "--quiet"})
                .exit_code,
            0);
  const SyntheticScan scan = synthesize(Shape::Cube, {.points = 200, .outliers = 0.1});
  const PointCloud noisy = read_cloud("out.ply");
  EXPECT_EQ(noisy.size(), 220U);
  EXPECT_TRUE(noisy.normals.empty());
  EXPECT_TRUE(noisy.attributes.empty());
  EXPECT_TRUE(noisy.layout.comments.empty());
  const PointCloud clean = read_cloud("clean.ply");
  EXPECT_TRUE(clean.points == scan.clean);
  EXPECT_TRUE(clean.normals == scan.normals);
  ASSERT_EQ(clean.attributes.size(), 1U);
  EXPECT_EQ(clean.attributes[0].name, "outlier");
  EXPECT_EQ(std::get<std::vector<std::uint8_t>>(clean.attributes[0].values), scan.outlier);
}

TEST_F(CliSynth, TextOutputsHoldTheSame) {
  ASSERT_EQ(synth({"cube", "out.xyz", "--points", "20", "--clean", "clean.csv"}).exit_code, 0);
  const SyntheticScan scan = synthesize(Shape::Cube, {.points = 20});
  EXPECT_TRUE(read_cloud("out.xyz").points == scan.cloud.points);
  EXPECT_TRUE(read_cloud("clean.csv").normals == scan.normals);
  EXPECT_EQ(lines_of(read_text("clean.csv"))[0], "x,y,z,nx,ny,nz,outlier");
}

TEST_F(CliSynth, ScansAMeshFile) {
  write_mesh("mesh.ply", shape_mesh(Shape::Part));
  const Outcome outcome =
      synth({"mesh.ply", "out.ply", "--points", "300", "--sampling", "scanner"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("300 points written to out.ply"));
  const SynthOptions options{.points = 300, .sampling = Sampling::Scanner};
  EXPECT_TRUE(read_cloud("out.ply").points == synthesize(Shape::Part, options).cloud.points);
}

TEST_F(CliSynth, RefusesWhatItCannotUnderstand) {
  expect_usage_error({"cow", "out.ply"}, "SHAPE_OR_MESH cow: neither a file nor one of part, cube");
  expect_usage_error({"cube", "out.ply", "--thickness", "0.1"},
                     "--thickness belongs to thin-plate");
  expect_usage_error({"cube", "out.ply", "--noise", "0.1", "--noise-spacings", "1"},
                     "--noise excludes --noise-spacings");
  expect_usage_error({"cube", "out.ply", "--noise-spacings", "-1"}, "noise must be");
  expect_usage_error({"cube", "out.ply", "--noise-kind", "loud"}, "--noise-kind: loud not in");
  expect_usage_error({"cube", "out.ply", "--sampling", "grid"}, "--sampling: grid not in");
  expect_usage_error({"cube", "out.ply", "--outliers", "2"}, "outliers must be in [0, 1], got 2");
  expect_usage_error({"cube", "out.ply", "--cluster-outliers", "-1"},
                     "--cluster-outliers must be in [0, 1], got -1");
  expect_usage_error({"thin-plate", "out.ply", "--thickness", "1"},
                     "thickness must be in (0, 1), got 1");
  expect_usage_error({"cube", "out.ply", "--points", "0"}, "points must be >= 1, got 0");
  expect_usage_error({"cube", "out.ply", "--clean", "clean.docx"}, "clean.docx: the extension");
}

TEST_F(CliSynth, OverwritesNothingThatItNeeds) {
  write_mesh("mesh.ply", shape_mesh(Shape::Cube));
  const std::string before = read_text("mesh.ply");
  expect_usage_error({"mesh.ply", "mesh.ply"},
                     "OUT mesh.ply would overwrite SHAPE_OR_MESH mesh.ply");
  expect_usage_error({"mesh.ply", "out.ply", "--truth", "mesh.ply"}, "--truth mesh.ply would");
  expect_usage_error({"mesh.ply", "out.ply", "--clean", "mesh.ply"}, "--clean mesh.ply would");
  expect_usage_error({"cube", "out.ply", "--clean", "out.ply"},
                     "OUT out.ply and --clean out.ply would be");
  expect_usage_error({"cube", "out.ply", "--clean", "t.ply", "--truth", "t.ply"}, "--clean t.ply");
  EXPECT_EQ(read_text("mesh.ply"), before);
}

TEST_F(CliSynth, TellsFilesFromDataWithoutAnAnswer) {
  EXPECT_EQ(synth({"missing.ply", "out.ply"}).exit_code, 3);
  EXPECT_EQ(synth({"cube", "out.ply", "--clean", "no/clean.ply"}).exit_code, 3);
  write_mesh("line.ply", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}});
  EXPECT_EQ(synth({"line.ply", "out.ply"}).exit_code, 4);
  const Outcome crowded = synth({"cube", "out.ply", "--points", "50", "--cluster-outliers", "0.5"});
  EXPECT_EQ(crowded.exit_code, 4);
  EXPECT_THAT(crowded.err, HasSubstr("cluster"));
  EXPECT_FALSE(std::filesystem::exists("out.ply"));
}

}  // namespace
}  // namespace deburr::cli

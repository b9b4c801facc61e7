// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "deburr/io.hpp"
#include "deburr/metrics.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// The table of `deburr compare`: what scripts read, and what it says where there is no number.

namespace deburr::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class CliCompareTable : public CliTest {};

// Scripts read these lines by their first word and third field.
TEST_F(CliCompareTable, PrintsATableThatScriptsCanRead) {
  const SyntheticScan scan = synthesize_part({.points = 3000});
  PointCloud cloud = scan.cloud;
  cloud.normals.assign(3000, Vec3{0, 0, 1});
  cloud.attributes.push_back({"deburr_label", std::vector<std::uint8_t>(3000, 1), {}});
  write_cloud("cloud.ply", cloud);
  PointCloud clean = synthesize_part({.points = 3000, .noise = 0}).cloud;
  clean.normals = cloud.normals;
  write_cloud("clean.ply", clean);
  write_mesh("truth.ply", scan.truth);
  const std::string text =
      run_program({"compare", "cloud.ply", "--truth", "truth.ply", "--clean", "clean.ply"}).out;
  const DistanceError error = compare_to_surface(cloud.points, scan.truth);
  for (const auto& [name, value] :
       {std::pair{"mean", error.mean}, {"rms", error.rms}, {"maximum", error.maximum}}) {
    int found = 0;
    for (const std::string& line : lines_of(text)) {
      std::istringstream words(line);
      std::string first;
      double absolute = 0;
      double relative = 0;
      if (!(words >> first) || first != name) continue;
      ++found;
      ASSERT_TRUE(words >> absolute >> relative) << line;
      EXPECT_NEAR(absolute, value, 1e-5 * value);
      EXPECT_NEAR(relative, 100 * value / error.diagonal, 1e-5 * 100 * value / error.diagonal);
    }
    EXPECT_EQ(found, 1) << name;
  }
  for (const char* row :
       {"95 percent", "coverage", "normals", "at edges", "edges", "corners", "offset"}) {
    EXPECT_THAT(text, HasSubstr(std::string("\n") + row + " ")) << row;
  }
  EXPECT_THAT(text, HasSubstr("corners     precision -, recall 0.0 %"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  for (const std::string& line : lines_of(text)) EXPECT_LE(line.size(), 79U) << line;
}

/// The corners of a cube, or other points, against the cube.
struct Told {
  std::string text;
  json figures;
};

Told compared(const std::vector<Vec3>& points, const std::string& truth) {
  PointCloud cloud;
  cloud.points = points;
  write_cloud("points.ply", cloud);
  const std::vector<std::string> args{"compare", "points.ply", "--truth", truth};
  std::vector<std::string> as_json = args;
  as_json.emplace_back("--json");
  const Outcome outcome = run_program(args);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, Not(HasSubstr("nan")));
  EXPECT_THAT(outcome.out, Not(HasSubstr("inf")));
  return {outcome.out, json::parse(run_program(as_json).out)};
}

TEST_F(CliCompareTable, HasNoRatioWhereNothingIsOff) {
  write_mesh("cube.ply", synthesize(Shape::Cube, {.points = 1}).truth);
  const std::vector<Vec3> corners = read_mesh("cube.ply").vertices;
  const Told exact = compared(corners, "cube.ply");
  EXPECT_THAT(exact.text, HasSubstr("\nat edges    0            mean error\n"));
  EXPECT_EQ(exact.figures["edge_mean"], 0);
  EXPECT_EQ(exact.figures["edge_mean_ratio"], json());
}

TEST_F(CliCompareTable, TellsNoErrorOfEdgesThatHaveNoPoints) {
  write_mesh("cube.ply", synthesize(Shape::Cube, {.points = 1}).truth);
  const TriangleMesh cube = read_mesh("cube.ply");
  Vec3 middle{};
  for (const Vec3& v : cube.vertices) middle = middle + 0.125 * v;
  const std::vector<Vec3> points(60, middle);
  const Told told = compared(points, "cube.ply");
  EXPECT_THAT(told.text, HasSubstr("\nat edges    -            mean error\n"));
  EXPECT_EQ(told.figures["edge_count"], 0);
  EXPECT_EQ(told.figures["edge_mean"], json());
  EXPECT_EQ(told.figures["edge_mean_ratio"], json());
  EXPECT_GT(told.figures["mean"], 0);
}

TEST_F(CliCompareTable, HasNoPercentOfATruthWithoutSize) {
  PointCloud one;
  one.points = {{1, 2, 3}};
  write_cloud("one.ply", one);
  const Told told = compared({{1, 2, 4}}, "one.ply");
  EXPECT_THAT(told.text, HasSubstr("\nmean        1            - of the diagonal\n"));
  EXPECT_EQ(told.figures["mean_relative"], json());
}

}  // namespace
}  // namespace deburr::cli

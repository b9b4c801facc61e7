// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "deburr/denoise.hpp"
#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// What `deburr info` tells of a file.

namespace deburr::cli {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class CliInfo : public CliTest {};

TEST_F(CliInfo, TellsWhatTheReportOfDenoiseTells) {
  PointCloud cloud = synthesize_part({.points = 1000}).cloud;
  cloud.points[3] = cloud.points[2];
  cloud.points[7].x = std::nan("");
  cloud.attributes.push_back({"red", std::vector<std::uint8_t>(1000), {}});
  cloud.layout.comments = {"made for a test"};
  write_cloud("in.ply", cloud);
  const Outcome outcome = run_program({"info", "in.ply", "--json"});
  ASSERT_EQ(outcome.exit_code, 0);
  const json info = json::parse(outcome.out);
  // Info measures all points, denoise those that are no outliers.
  const Report expected = denoise(cloud, {.automatic = {.outliers = OutlierAction::Keep}}).report;
  EXPECT_EQ(info["points"], 1000);
  EXPECT_EQ(info["non_finite"], 1);
  EXPECT_EQ(info["duplicates"], 1);
  EXPECT_EQ(info["comments"], 1);
  EXPECT_NEAR(info["spacing"], expected.spacing, 1e-9 * expected.spacing);
  EXPECT_NEAR(info["noise"], expected.noise, 1e-6 * expected.noise);
  EXPECT_DOUBLE_EQ(info["noise_in_spacings"].get<double>(),
                   info["noise"].get<double>() / info["spacing"].get<double>());
  EXPECT_EQ(info["fields"].back(), json({{"name", "red"}, {"type", "uint8"}, {"list", false}}));
  double lowest = HUGE_VAL;
  for (const Vec3& p : cloud.points) lowest = is_finite(p) ? std::min(lowest, p.x) : lowest;
  EXPECT_EQ(info["bounding_box"]["min"][0], lowest);
  EXPECT_THAT(run_program({"info", "in.ply"}).out, HasSubstr("red uint8"));
}

TEST_F(CliInfo, OfNothingHasNoBox) {
  write_cloud("empty.ply", {});
  const Outcome outcome = run_program({"info", "empty.ply", "--json"});
  ASSERT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(json::parse(outcome.out)["bounding_box"].is_null());
}

TEST_F(CliInfo, NamesOtherElements) {
  write_mesh("mesh.ply", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
  const Outcome outcome = run_program({"info", "mesh.ply"});
  EXPECT_THAT(outcome.out, HasSubstr("face: 1 of (vertex_indices list of"));
}

// A name out of a file does not steer the terminal.
TEST_F(CliInfo, WritesControlCharactersAsText) {
  write_text("in.ply",
             "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
             "property float z\nproperty float a\x1b[2J\nend_header\n1 2 3 4\n");
  const Outcome outcome = run_program({"info", "in.ply"});
  EXPECT_THAT(outcome.out, HasSubstr("a\\x1b[2J float32"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace deburr::cli

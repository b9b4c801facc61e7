// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "deburr/denoise.hpp"
#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// Formats and standard streams.

namespace deburr::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CliFormats : public CliTest {
 protected:
  const PointCloud scan = synthesize_part({.points = 600, .noise = 0.004, .outliers = 0.05}).cloud;
};

const Attribute* find(const PointCloud& cloud, const std::string& name) {
  const auto found = std::ranges::find(cloud.attributes, name, &Attribute::name);
  return found != cloud.attributes.end() ? &*found : nullptr;
}

TEST_F(CliFormats, StreamsArePlyUnlessToldOtherwise) {
  write_cloud("scan.ply", scan);
  write_cloud("scan.csv", scan);
  const PointCloud expected = denoise(scan).cloud;
  const Outcome ply = run_program({"denoise", "-", "-"}, "scan.ply");
  ASSERT_EQ(ply.exit_code, 0) << ply.err;
  EXPECT_THAT(ply.err, HasSubstr("written to -"));
  write_text("out", ply.out);
  EXPECT_TRUE(read_cloud("out").points == expected.points);
  const Outcome csv =
      run_program({"denoise", "-", "-", "--in-format", "csv", "--format", "csv"}, "scan.csv");
  ASSERT_EQ(csv.exit_code, 0) << csv.err;
  write_text("out", csv.out);
  EXPECT_TRUE(read_cloud("out").points == expected.points);
  EXPECT_EQ(read_cloud("out").layout.encoding, Encoding::Text);
  EXPECT_EQ(run_program({"info", "-"}, "scan.ply").out.find("not finite"),
            run_program({"info", "-"}, "scan.csv").out.find("not finite"));
  const Outcome synth = run_program({"synth", "cube", "-", "--points", "10"});
  EXPECT_THAT(synth.out, testing::StartsWith("ply\n"));
  const Outcome both = run_program({"denoise", "-", "-", "--json"}, "scan.ply");
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.err, HasSubstr("OUT - and --json would be written to the same place"));
}

TEST_F(CliFormats, FormatsAreTakenByName) {
  write_cloud("scan.ply", scan);
  ASSERT_EQ(run_program({"denoise", "scan.ply", "out.dat", "--format", "las"}).exit_code, 0);
  EXPECT_EQ(read_cloud("out.dat").layout.encoding, Encoding::Las);
  const Outcome out = run_program({"denoise", "scan.ply", "out.dat", "--format", "docx"});
  EXPECT_EQ(out.exit_code, 2);
  EXPECT_THAT(out.err, HasSubstr("--format docx: must be one of ply las pcd"));
  const Outcome in = run_program({"info", "scan.ply", "--in-format", "docx"});
  EXPECT_EQ(in.exit_code, 2);
  EXPECT_THAT(in.err, HasSubstr("--in-format docx: must be one of ply las pcd"));
  EXPECT_EQ(run_program({"info", "scan.ply", "--in-format", "las"}).exit_code, 3);
}

// Text has classes as integers of any size.
TEST_F(CliFormats, LasKeepsClassesOfAnyType) {
  PointCloud classified = scan;
  classified.attributes.push_back(
      {"classification", std::vector<std::int32_t>(scan.size(), 2), {}});
  write_cloud("scan.ply", classified);
  ASSERT_EQ(run_program({"denoise", "scan.ply", "out.las"}).exit_code, 0);
  const PointCloud out = read_cloud("out.las");
  const auto classes = std::get<std::vector<std::uint8_t>>(find(out, "classification")->values);
  const DenoiseResult expected = denoise(scan);
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(classes[i], expected.outliers[i] != 0 ? 7 : 2) << i;
  }
}

TEST_F(CliFormats, LasGetsTheClassOfOutliersAndAGridForTheMovement) {
  // On a grid of a tenth of the noise.
  write_cloud("scan.las", scan);
  PointCloud coarse = read_cloud("scan.las");
  for (HeaderBlock& block : coarse.layout.blocks) {
    const double scale = 0.05;
    if (block.name == "LAS header") {
      for (std::size_t k = 0; k < 3; ++k) {
        block.data.replace(131 + 8 * k, 8, reinterpret_cast<const char*>(&scale), 8);
      }
    }
  }
  write_cloud("scan.las", coarse);
  coarse = read_cloud("scan.las");
  const Outcome outcome = run_program({"denoise", "scan.las", "out.las"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, testing::Not(HasSubstr("warning")));
  const PointCloud out = read_cloud("out.las");
  const DenoiseResult expected = denoise(coarse);
  const auto classes = std::get<std::vector<std::uint8_t>>(find(out, "classification")->values);
  EXPECT_EQ(find(out, "deburr_outlier"), nullptr);
  EXPECT_NE(find(out, "deburr_label"), nullptr);
  EXPECT_EQ(out.normals.size(), scan.size());
  std::size_t outliers = 0;
  double squares = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    EXPECT_EQ(classes[i], expected.outliers[i] != 0 ? 7 : 0) << i;
    outliers += expected.outliers[i];
    EXPECT_TRUE(expected.displacement[i] != 0 || out.points[i] == coarse.points[i]) << i;
    squares += squared_norm(coarse.points[i] - expected.cloud.points[i]);
    EXPECT_LT(norm(out.points[i] - expected.cloud.points[i]), 0.05 / 2) << i;
  }
  EXPECT_GT(outliers, 5U);
  double scale = 0;
  const std::string file = read_text("out.las");
  file.copy(reinterpret_cast<char*>(&scale), 8, 131);
  const double rms = std::sqrt(squares / static_cast<double>(out.size()));
  EXPECT_LE(scale, rms / 32);
  EXPECT_GT(scale, rms / 128);
}

TEST_F(CliFormats, MeshesKeepTheirFaces) {
  write_mesh("part.ply", synthesize_part({.points = 10}).truth);
  for (const std::string format : {"stl", "obj", "off", "ply"}) {
    const std::string in = "in." + format;
    write_cloud(in, read_cloud("part.ply"));
    const Outcome outcome = run_program({"denoise", in, "out." + format, "--outliers", "keep"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(read_mesh("out." + format).triangles.size(), read_mesh(in).triangles.size());
    EXPECT_EQ(run_program({"compare", in, "--truth", "out." + format}).exit_code, 0);
  }
}

TEST_F(CliFormats, FacesGoWithTheirPointsAndOthersStay) {
  // A square of 30 x 30 points, of which one face goes to a point far away.
  constexpr int side = 30;
  TriangleMesh mesh;
  for (int i = 0; i < side * side; ++i) {
    mesh.vertices.push_back({0.1 * (i % side), 0.1 * (i / side), 0.001 * (i * 7 % 5)});
  }
  mesh.vertices.insert(mesh.vertices.begin(), {1.5, 1.5, 9});
  const auto corner = [](int x, int y) { return static_cast<std::uint32_t>(1 + x + side * y); };
  for (int x = 0; x + 1 < side; ++x) {
    for (int y = 0; y + 1 < side; ++y) {
      mesh.triangles.push_back({corner(x, y), corner(x + 1, y), corner(x + 1, y + 1)});
      mesh.triangles.push_back({corner(x, y), corner(x + 1, y + 1), corner(x, y + 1)});
    }
  }
  const std::vector<std::array<std::uint32_t, 3>> kept = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.begin(), {corner(15, 15), corner(16, 15), 0});
  write_mesh("part.ply", mesh);
  for (const std::string format : {"stl", "obj", "off", "ply"}) {
    const std::string in = "in." + format;
    write_cloud(in, read_cloud("part.ply"));
    const Outcome outcome = run_program({"denoise", in, "out." + format, "--outliers", "remove"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("warning: " + in +
                                       ": 1 of 1683 items of 'face' left out with their points"));
    const TriangleMesh out = read_mesh("out." + format);
    ASSERT_EQ(out.vertices.size(), mesh.vertices.size() - 1);
    ASSERT_EQ(out.triangles.size(), kept.size());
    for (std::size_t face = 0; face < kept.size(); ++face) {
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_LT(norm(out.vertices[out.triangles[face][k]] - mesh.vertices[kept[face][k]]), 0.05);
      }
    }
  }
}

TEST_F(CliFormats, WarnsOfWhatIsLost) {
  PointCloud cloud = scan;
  cloud.attributes = {{"quality", std::vector<float>(scan.size()), {}}};
  write_cloud("scan.ply", cloud);
  const Outcome outcome = run_program({"denoise", "scan.ply", "out.obj"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("deburr: warning: OBJ cannot hold the numbers 'quality'"));
  const auto json =
      nlohmann::json::parse(run_program({"denoise", "scan.ply", "out.obj", "--json"}).out);
  EXPECT_THAT(json["warnings"], ElementsAre(HasSubstr("'quality'")));
  for (Vec3& p : cloud.points) p.x += 5e6;
  cloud.layout.encoding = Encoding::PcdBinary;
  for (const char* name : {"x", "y", "z"}) {
    cloud.layout.fields.push_back({name, ScalarType::Float32});
  }
  write_cloud("far.pcd", cloud);
  EXPECT_THAT(run_program({"info", "far.pcd"}).err,
              HasSubstr("warning: far.pcd: the coordinates are 32-bit floats"));
  EXPECT_THAT(run_program({"info", "far.pcd", "--quiet"}).err, IsEmpty());
}

}  // namespace
}  // namespace deburr::cli

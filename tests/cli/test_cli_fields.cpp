// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "deburr/denoise.hpp"
#include "deburr/io.hpp"
#include "deburr/synth.hpp"
#include "run_program.hpp"

// The fields that `deburr denoise` writes for every point.

namespace deburr::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CliFields : public CliTest {};

PointCloud part(std::size_t points) { return synthesize_part({.points = points}).cloud; }

std::vector<std::string> attribute_names(const PointCloud& cloud) {
  std::vector<std::string> names;
  for (const Attribute& attribute : cloud.attributes) names.push_back(attribute.name);
  return names;
}

template <typename T>
std::vector<T> values_of(const PointCloud& cloud, const std::string& name) {
  for (const Attribute& attribute : cloud.attributes) {
    if (attribute.name == name) return std::get<std::vector<T>>(attribute.values);
  }
  return {};
}

TEST_F(CliFields, MarksOutliersWhereItIsAsked) {
  const PointCloud cloud =
      synthesize_part({.points = 1500, .noise = 0.004, .outliers = 0.05}).cloud;
  write_cloud("in.ply", cloud);
  ASSERT_EQ(run_program({"denoise", "in.ply", "out.ply", "--add", "outlier"}).exit_code, 0);
  const PointCloud written = read_cloud("out.ply");
  EXPECT_EQ(values_of<std::uint8_t>(written, "deburr_outlier"), denoise(cloud).outliers);
}

TEST_F(CliFields, LeavesTheColumnsOfTextAlone) {
  write_cloud("in.xyz", part(500));
  ASSERT_EQ(run_program({"denoise", "in.xyz", "out.xyz"}).exit_code, 0);
  const PointCloud plain = read_cloud("out.xyz");
  EXPECT_THAT(plain.normals, IsEmpty());
  EXPECT_THAT(plain.attributes, IsEmpty());
  EXPECT_EQ(lines_of(read_text("out.xyz")).size(), 500U);

  ASSERT_EQ(run_program({"denoise", "in.xyz", "more.xyz", "--add", "label,normals"}).exit_code, 0);
  const PointCloud more = read_cloud("more.xyz");
  EXPECT_THAT(attribute_names(more), ElementsAre("deburr_label"));
  EXPECT_EQ(more.normals.size(), 500U);
}

TEST_F(CliFields, AddsOnlyWhatIsAskedFor) {
  write_cloud("in.ply", part(300));
  ASSERT_EQ(run_program({"denoise", "in.ply", "out.ply", "--add", "none"}).exit_code, 0);
  EXPECT_THAT(read_cloud("out.ply").normals, IsEmpty());
  EXPECT_THAT(read_cloud("out.ply").attributes, IsEmpty());
  ASSERT_EQ(run_program({"denoise", "in.ply", "out.ply", "--add", "displacement"}).exit_code, 0);
  EXPECT_THAT(read_cloud("out.ply").normals, IsEmpty());
  EXPECT_THAT(attribute_names(read_cloud("out.ply")), ElementsAre("deburr_displacement"));
}

TEST_F(CliFields, WritesNewNormalsWhereThereWereSome) {
  PointCloud cloud = part(300);
  cloud.normals.assign(cloud.size(), Vec3{0, 0, 1});
  write_cloud("in.ply", cloud);
  ASSERT_EQ(run_program({"denoise", "in.ply", "out.ply", "--add", "none"}).exit_code, 0);
  EXPECT_TRUE(read_cloud("out.ply").normals == denoise(cloud).cloud.normals);
}

TEST_F(CliFields, TakesItsOwnOutputInPlace) {
  write_cloud("scan.ply", part(400));
  for (int run = 0; run < 2; ++run) {
    ASSERT_EQ(run_program({"denoise", "scan.ply", "scan.ply"}).exit_code, 0);
    EXPECT_THAT(attribute_names(read_cloud("scan.ply")),
                ElementsAre("deburr_label", "deburr_displacement", "deburr_outlier"));
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator("."), {}), 1);
}

// A field ny alone is no normal, and its name is needed for one.
TEST_F(CliFields, AFieldWithTheNameOfANormalGetsAnother) {
  std::string text = "x,y,z,nx\n";
  const PointCloud cloud = part(50);
  for (const Vec3& p : cloud.points) {
    text += std::to_string(p.x) + "," + std::to_string(p.y) + "," + std::to_string(p.z) + ",0.5\n";
  }
  write_text("in.csv", text);
  const Outcome outcome = run_program({"denoise", "in.csv", "out.ply"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("deburr: warning: the field 'nx' was written as 'nx_', since "
                                     "the normals have its name\n"));
  EXPECT_EQ(read_cloud("out.ply").normals.size(), 50U);
  EXPECT_EQ(values_of<double>(read_cloud("out.ply"), "nx_"), std::vector<double>(50, 0.5));
  ASSERT_EQ(run_program({"denoise", "in.csv", "out.csv"}).exit_code, 0);
  EXPECT_THAT(attribute_names(read_cloud("out.csv")), ElementsAre("nx"));
}

}  // namespace
}  // namespace deburr::cli

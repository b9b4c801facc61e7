// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "support/cloud_files.hpp"

// Fields whose names are those of normals, in clouds that had none.

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<double> lone_values{0.25, 0.5, -1};
const std::vector<Vec3> normals{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};

/// Three points with a number each, in text, from which any format can be made.
PointCloud with_field(const std::string& name) {
  return parsed("x y z " + name + "\n1 2 3 0.25\n4 5 6 0.5\n7 8 9 -1\n");
}

TEST(LoneNormal, IsAFieldLikeAnyOther) {
  for (const std::string name : {"nx", "ny", "NZ", "normal_y", "NormalX"}) {
    const PointCloud cloud = with_field(name);
    EXPECT_THAT(cloud.normals, IsEmpty());
    EXPECT_EQ(values_of<double>(cloud, name), lone_values);
  }
}

TEST(LoneNormal, GivesWayToNormalsInEveryFormat) {
  const TempDir dir;
  for (const std::string name : {"ny", "NZ", "normal_y"}) {
    for (const std::string from : {"csv", "ply", "pcd", "las"}) {
      // As a file of the format has it.
      (void)write_cloud(dir / ("in." + from), with_field(name));
      PointCloud cloud = read_cloud(dir / ("in." + from));
      ASSERT_EQ(values_of<double>(cloud, name), lone_values) << from;
      cloud.normals = normals;
      for (const std::string to : {"csv", "ply", "pcd", "las"}) {
        const std::string trace = std::string(name).append(" of ") + from + " to " + to;
        const std::vector<std::string> warnings = write_cloud(dir / ("out." + to), cloud);
        const std::string warning =
            "the field '" + name + "' was written as '" + name + "_', since the normals have";
        EXPECT_EQ(std::ranges::count_if(
                      warnings, [&](const std::string& s) { return s.starts_with(warning); }),
                  1)
            << trace;
        PointCloud out = read_cloud(dir / ("out." + to));
        EXPECT_TRUE(out.normals == normals) << trace;
        EXPECT_EQ(values_of<double>(out, name + "_"), lone_values) << trace;
        // The new name is one to stay with.
        (void)write_cloud(dir / ("out." + to), out);
        out = read_cloud(dir / ("out." + to));
        EXPECT_TRUE(out.normals == normals) << trace;
        EXPECT_EQ(values_of<double>(out, name + "_"), lone_values) << trace;
      }
    }
  }
}

TEST(LoneNormal, TakesANameThatIsFree) {
  const TempDir dir;
  PointCloud cloud = parsed("x y z ny ny_ nx\n1 2 3 4 5 6\n");
  cloud.normals = {{0, 0, 1}};
  (void)write_cloud(dir / "out.ply", cloud);
  EXPECT_THAT(field_names(read_cloud(dir / "out.ply")),
              ElementsAre("x", "y", "z", "ny__", "ny_", "nx_", "nx", "ny", "nz"));
}

// Fields of a file that has normals under other names keep theirs.
TEST(LoneNormal, StaysWhereTheNormalsWereThereBefore) {
  const TempDir dir;
  const std::string text = "x y z ny normal_x normal_y normal_z\n1 2 3 0.5 0 0.6 0.8\n";
  const PointCloud cloud = parsed(text);
  EXPECT_THAT(cloud.normals, ElementsAre(Vec3{0, 0.6, 0.8}));
  EXPECT_EQ(values_of<double>(cloud, "ny"), std::vector{0.5});
  std::vector<std::string> warnings;
  EXPECT_EQ(written_as(dir, cloud, "out.xyz", &warnings), text);
  EXPECT_THAT(warnings, IsEmpty());
}

// PCD has names of its own for normals.
TEST(LoneNormal, GivesWayToTheNamesOfAnotherFormat) {
  const TempDir dir;
  const PointCloud cloud = parsed("x y z normal_y nx ny nz\n1 2 3 0.5 0 0.6 0.8\n");
  (void)write_cloud(dir / "out.pcd", cloud);
  const PointCloud out = read_cloud(dir / "out.pcd");
  EXPECT_THAT(out.normals, ElementsAre(Vec3{0, 0.6, 0.8}));
  EXPECT_EQ(values_of<double>(out, "normal_y_"), std::vector{0.5});
}

TEST(LoneNormal, StaysInACloudWithoutNormals) {
  const TempDir dir;
  std::vector<std::string> warnings;
  const std::string text = written_as(dir, with_field("ny"), "out.ply", &warnings);
  EXPECT_THAT(text, HasSubstr("property double ny\n"));
  EXPECT_THAT(warnings, IsEmpty());
}

}  // namespace
}  // namespace deburr

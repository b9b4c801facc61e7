// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "support/broken_files.hpp"
#include "support/cloud_files.hpp"
#include "support/same_cloud.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Obj, WritesPlainMeshesBack) {
  const TempDir dir;
  for (const std::string file :
       {"v 1 2 3\nv 4 5 6.5\nv 0.1 -0 1e+20\nf 1 2 3\nf 3 2 1\n", "v 1 2 3\n",
        "# by hand\n#\nv 1 2 3 0.25 0.5 1.5\nv 4 5 6 1 0 0\n", "v 1 2 3 1\nv 1 2 3 0.5\n",
        "# art /\\\nv 1 2 3\n",
        "v 1 2 3\nv 4 5 6\nv 7 8 9\nv 0 0 0\nvn 0 0 1\nvn 0 1 0\nvn 1 0 0\nvn 0 0 2\n"
        "f 1//1 2//2 3//3 4//4\n"}) {
    SCOPED_TRACE(file);
    const PointCloud cloud = parsed(file);
    EXPECT_EQ(cloud.layout.encoding, Encoding::Obj);
    std::vector<std::string> warnings;
    EXPECT_EQ(written_as(dir, cloud, "a.obj", &warnings), file);
    EXPECT_THAT(warnings, IsEmpty());
  }
}

const char* const rich =
    "# a scene\nmtllib scene.mtl\no first\nv 1 2 3\nv 4 5 6\nv 7 8 9\nvt 0 0\nvt 0 1\nvt 1 1\n"
    "vn 0 0 1\nusemtl red\ns off\nf 1/1/1 2/2/1 3/3/1\n\no second\ng a b\nv 0 0 1\nf -1 -2 -3\n"
    "l 1 2\n";

TEST(Obj, KeepsCommentsAmongOtherLinesToTheLastBlank) {
  const std::string file = "  #c  \no a\nv 1 2 3\n";
  const TempDir dir;
  EXPECT_EQ(written_as(dir, parsed(file), "a.obj"), file);
}

TEST(Obj, WithoutPointsGetsNoComment) {
  const PointCloud cloud = parsed(" \n", "obj");
  const TempDir dir;
  EXPECT_THAT(parsed(written_as(dir, cloud, "a.obj"), "obj").layout.comments, IsEmpty());
}

TEST(Obj, KeepsAllOtherLines) {
  const TempDir dir;
  PointCloud cloud = parsed(rich);
  EXPECT_EQ(written_as(dir, cloud, "a.obj"), rich);
  cloud.points[3] = {0.5, 0, 1};
  std::string moved = rich;
  moved.replace(moved.find("v 0 0 1"), 7, "v 0.5 0 1");
  EXPECT_EQ(written_as(dir, cloud, "a.obj"), moved);
  // Without them nothing is lost silently.
  std::vector<std::string> warnings;
  (void)written_as(dir, cloud, "a.ply", &warnings);
  EXPECT_THAT(warnings, ElementsAre("PLY cannot hold: OBJ lines (vn mtllib o vt usemtl s g l); "
                                    "left out"));
  cloud.points.pop_back();
  cloud.layout.elements.clear();
  EXPECT_EQ(written_as(dir, cloud, "a.obj", &warnings), "# a scene\nv 1 2 3\nv 4 5 6\nv 7 8 9\n");
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("which may refer to points that are not there")));
}

TEST(Obj, TakesNormalsOnlyIfThereIsOneForEachVertex) {
  const std::string vertices = "v 1 2 3\nv 4 5 6\nvn 0 0 1\nvn 0 1 0\n";
  EXPECT_THAT(parsed(vertices).normals, ElementsAre(Vec3{0, 0, 1}, Vec3{0, 1, 0}));
  EXPECT_EQ(parsed(vertices + "f 1//1 2//2 1//1\n").normals.size(), 2U);
  EXPECT_EQ(parsed(vertices + "f 1 2 1\n").normals.size(), 2U);
  EXPECT_THAT(parsed(vertices + "f 1//2 2//2 1//1\n").normals, IsEmpty());
  EXPECT_THAT(parsed(vertices + "f 1//-2 2//2 1//1\n").normals, IsEmpty());
  EXPECT_THAT(parsed(vertices + "vn 1 0 0\n").normals, IsEmpty());
}

TEST(Obj, AddsNormalsToLinesThatHaveNone) {
  const TempDir dir;
  PointCloud cloud = parsed("o a\nv 1 2 3\no b\nv 4 5 6\nl 1 2\n");
  cloud.normals = {{0, 0, 1}, {0, 1, 0}};
  const std::string file = written_as(dir, cloud, "a.obj");
  EXPECT_EQ(file, "o a\nv 1 2 3\no b\nv 4 5 6\nvn 0 0 1\nvn 0 1 0\nl 1 2\n");
  EXPECT_TRUE(same_values(parsed(file).normals, cloud.normals));
}

TEST(Obj, WritesBytesOfColoursAsFractions) {
  const TempDir dir;
  std::vector<std::uint8_t> every;
  PointCloud cloud;
  for (int i = 0; i < 256; ++i) {
    every.push_back(static_cast<std::uint8_t>(i));
    cloud.points.push_back({1.0 * i, 0, 0});
  }
  for (const char* name : {"red", "green", "blue"}) cloud.attributes.push_back({name, every, {}});
  const PointCloud again = parsed(written_as(dir, cloud, "a.obj"));
  EXPECT_THAT(get(dir / "a.obj"), testing::EndsWith("v 255 0 0 1 1 1\n"));
  EXPECT_EQ(values_of<std::uint8_t>(again, "green"), every);
  // What other programs round is kept as it is.
  EXPECT_THAT(values_of<double>(parsed("v 1 2 3 0.501961 0 0\n"), "red"), ElementsAre(0.501961));
}

TEST(Obj, WritesColoursOf16BitsExactly) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  cloud.attributes = {{"red", std::vector<std::uint16_t>{0, 65535, 1}, {}},
                      {"green", std::vector<std::uint16_t>{32768, 12345, 257}, {}},
                      {"blue", std::vector<std::uint16_t>{3, 2, 1}, {}}};
  std::vector<std::string> warnings;
  const PointCloud again = parsed(written_as(dir, cloud, "a.obj", &warnings));
  EXPECT_THAT(warnings, IsEmpty());
  expect_same(again.attributes, cloud.attributes);
  // Small integers are bytes, whatever their type; others are no colours.
  cloud.attributes[0].values = std::vector<std::int64_t>{0, 255, 1};
  cloud.attributes[1].values = std::vector<std::int64_t>{0, 255, 1};
  EXPECT_THAT(values_of<std::uint8_t>(parsed(written_as(dir, cloud, "a.obj")), "red"),
              ElementsAre(0, 255, 1));
  cloud.attributes[1].values = std::vector<std::int64_t>{0, 65536, 1};
  EXPECT_THAT(parsed(written_as(dir, cloud, "a.obj", &warnings)).attributes, IsEmpty());
  EXPECT_EQ(warnings.size(), 3U);
}

TEST(Obj, SaysWhatItCannotHold) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{1, 2, 3}};
  cloud.attributes = {{"label", std::vector<std::uint8_t>{2}, {}}};
  cloud.layout.elements = {{"camera", 2, {}, false}};
  EXPECT_THAT(write_cloud(dir / "a.obj", cloud),
              ElementsAre("OBJ cannot hold the integers 'label', which were left out",
                          "OBJ cannot hold the element 'camera' (2 items), which was left out"));
}

// A line that goes on to one that begins like a normal has none.
TEST(Obj, WritesNormalsBesideLinesThatGoOn) {
  const std::string lines = "vt \\\nvn !\n";
  const PointCloud cloud = parsed("v 1 2 3\nvn 0 0 1\n" + lines);
  ASSERT_EQ(cloud.normals, (std::vector<Vec3>{{0, 0, 1}}));
  const TempDir dir;
  EXPECT_EQ(written_as(dir, cloud, "a.obj"), "v 1 2 3\nvn 0 0 1\n" + lines);
}

TEST(Obj, TakesAllReturnsForTheEndOfALine) {
  const TempDir dir;
  const PointCloud cloud = parsed("# a\r\r\nv 1 2 3\r\r\n#\r\r");
  EXPECT_THAT(cloud.layout.comments, ElementsAre("a", ""));
  EXPECT_EQ(written_as(dir, cloud, "a.obj"), "# a\n#\nv 1 2 3\n");
}

// As the first line, it would say that all lines end with returns.
TEST(Obj, KeepsALineWithAReturnInItWhereNormalsStoodBefore) {
  const TempDir dir;
  const PointCloud cloud = parsed("vn 0 0 1\ng a\rb\nv 1 2 3\n");
  ASSERT_EQ(cloud.normals.size(), 1U);
  EXPECT_EQ(written_as(dir, cloud, "a.obj"), "\ng a\rb\nv 1 2 3\nvn 0 0 1\n");
  const PointCloud again = read_cloud(dir / "a.obj");
  expect_same(again, cloud);
  EXPECT_EQ(written_as(dir, again, "b.obj"), get(dir / "a.obj"));
}

TEST(Obj, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(error_of("v 1 2 3\nv 1 2\n"), "line 2: the line ends before z");
  EXPECT_EQ(error_of("v 1 2 3\nv 1 2 3x\n"), "line 2: '3x' is no value for z");
  EXPECT_THAT(error_of("v 1 2 3\nv 1,5 2 3\n"), HasSubstr("line 2: decimal commas"));
  EXPECT_EQ(error_of("v 1 2 3\nv 1 2 3 4\n"), "line 2: 4 numbers, but 3 before");
  EXPECT_EQ(error_of("v 1 2 3 4 5\n"), "line 1: a vertex has 3, 4, 6 or 7 numbers");
  EXPECT_EQ(error_of("v 1 2 3\nf 1 2 1\n"),
            "line 2: a face has vertex 2, but there are 1 vertices");
  EXPECT_EQ(error_of("v 1 2 3\nf 1 0 1\n"), "line 2: a face has vertex 0");
  EXPECT_EQ(error_of("v 1 2 3\nf 1 -2 1\n"), "line 2: a face has vertex -2");
  EXPECT_EQ(error_of("v 1 2 3\nf 1/1/1/1 1 1\n"), "line 2: a corner has at most three indices");
  EXPECT_EQ(error_of("v 1 2 3\nvn 0 0 1 \\\nv 1 2 3\n"),
            "line 2: faces and normals of more than one line are not read");
  EXPECT_EQ(error_of("v 1 2 3\nhello\n"), "line 2: unknown keyword 'hello'");
  EXPECT_EQ(error_of("v 1 2 3\nf 1 99999999999 1\n"),
            "line 2: '99999999999' is no value for a corner");
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "support/temp_dir.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string mesh_file(const std::string& type, const std::string& name, const std::string& faces,
                      int count) {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement face " +
         std::to_string(count) + "\nproperty list uchar " + type + " " + name +
         "\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" + faces;
}

std::string error_of_mesh(const TempDir& dir, const std::string& data) {
  put(dir / "m.ply", data);
  try {
    (void)read_mesh(dir / "m.ply");
  } catch (const IoError& e) {
    return e.what();
  }
  return "";
}

TEST(ReadMesh, SplitsFacesIntoFans) {
  const TempDir dir;
  for (const char* type : {"int", "uint8", "ushort"}) {
    for (const char* name : {"vertex_indices", "vertex_index"}) {
      put(dir / "m.ply", mesh_file(type, name, "4 0 1 2 3\n3 3 2 1\n", 2));
      const TriangleMesh mesh = read_mesh(dir / "m.ply");
      EXPECT_THAT(mesh.vertices,
                  ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}));
      EXPECT_THAT(mesh.triangles,
                  ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3), ElementsAre(3, 2, 1)));
    }
  }
}

TEST(ReadMesh, RefusesWhatIsNoMesh) {
  const TempDir dir;
  const std::string name = "vertex_indices";
  EXPECT_THAT(error_of_mesh(dir, mesh_file("int", name, "3 0 1 2\n3 0 1 4\n", 2)),
              HasSubstr("face 2 has vertex 4, but there are 4 vertices"));
  EXPECT_THAT(error_of_mesh(dir, mesh_file("int", name, "3 0 -1 2\n", 1)),
              HasSubstr("face 1 has vertex -1"));
  EXPECT_THAT(error_of_mesh(dir, mesh_file("int", name, "3 0 1 2\n0\n2 0 1\n", 3)),
              HasSubstr("face 2 has 0 corners"));
  EXPECT_THAT(error_of_mesh(dir, mesh_file("float", name, "3 0 1 2\n", 1)),
              HasSubstr("not integers"));
  EXPECT_THAT(error_of_mesh(dir, mesh_file("int", name, "", 0)), HasSubstr("no faces"));
  EXPECT_THAT(error_of_mesh(dir, mesh_file("int", "other", "3 0 1 2\n", 1)), HasSubstr("no faces"));
  EXPECT_THAT(error_of_mesh(dir, "0 0 0\n"), HasSubstr("the file has no faces"));
}

TEST(ReadMeshOrCloud, TakesAFileWithFacesAsAMesh) {
  const TempDir dir;
  const std::string name = "vertex_indices";
  put(dir / "m.ply", mesh_file("int", name, "4 0 1 2 3\n", 1));
  const auto mesh = read_mesh_or_cloud(dir / "m.ply");
  ASSERT_TRUE(std::holds_alternative<TriangleMesh>(mesh));
  EXPECT_EQ(std::get<TriangleMesh>(mesh).triangles, read_mesh(dir / "m.ply").triangles);
  EXPECT_EQ(std::get<TriangleMesh>(mesh).vertices, read_mesh(dir / "m.ply").vertices);
  put(dir / "none.ply", mesh_file("int", name, "", 0));
  put(dir / "points.xyz", "0 0 0\n1 0 0\n1 1 0\n0 1 0\n");
  for (const char* file : {"none.ply", "points.xyz"}) {
    const auto cloud = read_mesh_or_cloud(dir / file);
    ASSERT_TRUE(std::holds_alternative<PointCloud>(cloud)) << file;
    EXPECT_EQ(std::get<PointCloud>(cloud).points, read_mesh(dir / "m.ply").vertices);
  }
}

TEST(ReadMeshOrCloud, RefusesBrokenFaces) {
  const TempDir dir;
  put(dir / "other.ply", mesh_file("int", "other", "3 0 1 2\n", 1));
  put(dir / "broken.ply", mesh_file("int", "vertex_indices", "3 0 1 4\n", 1));
  for (const char* file : {"other.ply", "broken.ply", "missing.ply"}) {
    EXPECT_THROW((void)read_mesh_or_cloud(dir / file), IoError) << file;
  }
}

TEST(WriteMesh, IsReadBackAsItWas) {
  const TempDir dir;
  const TriangleMesh mesh{{{0.1, 1e300, -0.0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
  write_mesh(dir / "m.ply", mesh);
  const TriangleMesh again = read_mesh(dir / "m.ply");
  EXPECT_EQ(again.vertices, mesh.vertices);
  EXPECT_EQ(again.triangles, mesh.triangles);
  EXPECT_THAT(get(dir / "m.ply"), testing::StartsWith("ply\nformat binary_little_endian 1.0\n"
                                                      "element vertex 3\n"
                                                      "property double x\n"
                                                      "property double y\n"
                                                      "property double z\n"
                                                      "element face 2\n"
                                                      "property list uchar int vertex_indices\n"
                                                      "end_header\n"));
}

TEST(WriteMesh, RefusesCornersThatAreNoVertices) {
  const TempDir dir;
  EXPECT_THROW(write_mesh(dir / "m.ply", {{{0, 0, 0}}, {{0, 0, 1}}}), std::invalid_argument);
  EXPECT_EQ(dir.count(), 0);
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstring>

#include "deburr/error.hpp"
#include "support/broken_files.hpp"
#include "support/cloud_files.hpp"
#include "support/same_cloud.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Off, WritesWhatItReads) {
  const TempDir dir;
  for (const std::string file :
       {"OFF\n3 1 0\n1 2 3\n4 5 6.5\n0.1 -0 1e+20\n3 0 1 2\n", "OFF\n# by hand\n1 0 0\n1 2 3\n",
        "COFF\n2 0 0\n1 2 3 0 255 7 1\n4 5 6 1 2 3 4\n", "COFF\n1 0 0\n1 2 3 0.5 1.0 0.25\n",
        "NOFF\n1 0 0\n1 2 3 0 0 1\n", "STCNOFF\n1 0 0\n1 2 3 0 0 1 9 8 7 0.5 1.0\n",
        "OFF\n3 2 0\n1 2 3\n4 5 6\n7 8 9\n3 0 1 2 255 0 0\n3 2 1 0\n",
        "OFF\n3 1 0\n1 2 3\n4 5 6\n7 8 9\n4 0 1 2 0 0.5 1.0 0.0 1.0\n", "OFF\n0 0 0\n"}) {
    SCOPED_TRACE(file);
    const PointCloud cloud = parsed(file);
    EXPECT_EQ(cloud.layout.encoding, Encoding::Off);
    std::vector<std::string> warnings;
    EXPECT_EQ(written_as(dir, cloud, "a.off", &warnings), file);
    EXPECT_THAT(warnings, IsEmpty());
  }
}

TEST(Off, ReadsLooseFiles) {
  for (const std::string file :
       {"OFF 1 0 0\n1 2 3\n", "# c\nOFF # d\n\n1 0\n1 2 3 # e\n", "OFF\r\n1 0 0\r\n1 2 3\r\n"}) {
    EXPECT_THAT(parsed(file).points, ElementsAre(Vec3{1, 2, 3})) << file;
  }
  // The first word may be left out, if the name of the file says what it is.
  EXPECT_THAT(parsed("1 0 0\n1 2 3\n", "off").points, ElementsAre(Vec3{1, 2, 3}));
  EXPECT_THAT(parse_cloud({"a.off", "1 0 0\n1 2 3\n", {}}).points, ElementsAre(Vec3{1, 2, 3}));
  EXPECT_EQ(parsed("1 0 0\n1 2 3\n").size(), 2U);
}

TEST(Off, NamesTheLineOfWhatIsWrong) {
  EXPECT_EQ(error_of("OFF\n2 0 0\n1 2 3\n"),
            "line 2: 2 vertices and 0 faces are announced, 6 bytes are left");
  EXPECT_EQ(error_of("OFF\n1 1 0\n1.0000 2.000 3\n"), "line 4: the file ends before face 1 of 1");
  EXPECT_THAT(error_of("OFF\n1099511627776 0 0\n1 2 3\n"), HasSubstr("line 2: 1099511627776"));
  EXPECT_EQ(error_of("OFF\n-1 0 0\n"), "line 2: '-1' is no value for the number of vertices");
  EXPECT_EQ(error_of("OFF\n1 1 0\n1 2 3\n3 0 0 1\n"),
            "line 4: a face has vertex 1, but there are 1 vertices");
  EXPECT_EQ(error_of("OFF\n1 1 0\n1 2 3\n3 0 0\n"), "line 4: the line ends before a corner");
  EXPECT_THAT(error_of("OFF\n1 0 0\n1,5 2 3\n"), HasSubstr("line 3: decimal commas"));
  EXPECT_EQ(error_of("OFF\n1 0 0\n1 2 3 4\n"), "line 3: 1 numbers behind those of a vertex");
  EXPECT_EQ(error_of("OFF BINARY\n"), "line 1: binary OFF is not read");
}

/// Two triangles of a unit square.
std::string binary_stl(std::uint16_t word = 0) {
  std::string file(80, '\0');
  file.replace(0, 5, "solid");
  file.append("\2\0\0\0", 4);
  const float faces[2][12] = {{0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0},
                              {0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}};
  for (const auto& face : faces) {
    file.append(reinterpret_cast<const char*>(face), sizeof face);
    file.append(reinterpret_cast<const char*>(&word), 2);
  }
  return file;
}

const char* const text_stl =
    "solid a part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0.1\n"
    "endloop\nendfacet\nendsolid a part\nsolid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n"
    "vertex 1 1 0.1\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";

TEST(Stl, JoinsCornersAndWritesWhatItReads) {
  const TempDir dir;
  for (const std::uint16_t word : {std::uint16_t{0}, std::uint16_t{258}}) {
    const PointCloud cloud = parsed(binary_stl(word));
    EXPECT_EQ(cloud.layout.encoding, Encoding::StlBinary);
    EXPECT_THAT(cloud.points,
                ElementsAre(Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}));
    std::vector<std::string> warnings;
    EXPECT_EQ(written_as(dir, cloud, "a.stl", &warnings), binary_stl(word));
    EXPECT_THAT(warnings, IsEmpty());
  }
  PointCloud cloud = parsed(text_stl);
  EXPECT_EQ(cloud.layout.encoding, Encoding::StlAscii);
  EXPECT_EQ(cloud.size(), 4U);
  // The first normal is not that of its face: it is made anew.
  EXPECT_THAT(written_as(dir, cloud, "a.stl"),
              testing::StartsWith("solid a part\nfacet normal 0 -0.0995"));
  for (Vec3& p : cloud.points) p.z = 0;
  std::string flat = text_stl;
  for (std::size_t at = flat.find("0.1"); at != std::string::npos; at = flat.find("0.1")) {
    flat.replace(at, 3, "0");
  }
  EXPECT_EQ(written_as(dir, cloud, "a.stl"), flat);
}

TEST(Stl, MovesTheCornersOfFaces) {
  const TempDir dir;
  PointCloud cloud = parsed(binary_stl());
  for (Vec3& p : cloud.points) p = {p.z, p.x, p.y};
  (void)write_cloud(dir / "a.stl", cloud);
  const TriangleMesh mesh = read_mesh(dir / "a.stl");
  EXPECT_EQ(mesh.vertices, cloud.points);
  EXPECT_THAT(mesh.triangles, ElementsAre(ElementsAre(0, 1, 2), ElementsAre(0, 2, 3)));
  const PointCloud again = read_cloud(dir / "a.stl");
  // The normal that was one follows, that which was none stays none.
  EXPECT_THAT(std::get<std::vector<float>>(again.layout.elements.at(0).attributes.at(1).values),
              ElementsAre(1, 0));
}

TEST(Stl, SplitsFacesAndSaysWhatItCannotHold) {
  const TempDir dir;
  PointCloud cloud = parsed("OFF\n5 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 9 9\n4 0 1 2 3\n");
  cloud.layout.comments = {"c"};
  cloud.normals.resize(5);
  cloud.attributes = {{"a", std::vector<float>(5), {}}};
  std::vector<std::string> warnings;
  EXPECT_EQ(parsed(written_as(dir, cloud, "a.stl", &warnings)).size(), 4U);
  EXPECT_THAT(warnings,
              ElementsAre("STL cannot hold the numbers 'a', which were left out",
                          "STL cannot hold normals of points, which were left out",
                          "STL cannot hold comments, 1 left out",
                          "STL holds points of faces only, 1 others were left out",
                          "STL holds triangles only, other faces were split or left out"));
  EXPECT_EQ(read_mesh(dir / "a.stl").triangles.size(), 2U);
  cloud.layout.elements.clear();
  EXPECT_THROW((void)write_cloud(dir / "b.stl", cloud), DataError);
  EXPECT_EQ(dir.count(), 1);
}

TEST(Stl, NamesThePlaceOfWhatIsWrong) {
  const std::string binary = binary_stl();
  const auto error_in_stl = [](const std::string& data) {
    try {
      (void)parsed(data, "stl");
    } catch (const IoError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(error_in_stl(binary + "tail"), "");
  std::string other = binary;
  other.replace(0, 5, "other");
  EXPECT_EQ(error_in_stl(other.substr(0, 183)), "given: byte 183: the file ends in face 2 of 2");
  EXPECT_EQ(error_in_stl(other.substr(0, 50)), "given: byte 50: the file ends in the header");
  const std::string text = text_stl;
  EXPECT_THAT(error_in_stl(text.substr(0, 100)),
              HasSubstr("line 8: the file ends before endsolid"));
  EXPECT_THAT(error_in_stl("solid\nfacet normal 0 0 1\nendfacet\n"),
              HasSubstr("line 3: a facet with another number of vertices than 3"));
  EXPECT_THAT(error_in_stl("solid\nfacet normal 0 0 1\nvertex 1,5 0 0\n"),
              HasSubstr("line 3: decimal commas"));
  EXPECT_THAT(error_in_stl("solid\nvertex 1 0 0\nendsolid facet\n"),
              HasSubstr("line 2: a vertex outside of a facet"));
  EXPECT_THAT(error_in_stl("solid\nfacet\n"), HasSubstr("line 2: the line ends before x"));
}

}  // namespace
}  // namespace deburr

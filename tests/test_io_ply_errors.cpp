// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "support/broken_files.hpp"
#include "support/ply_files.hpp"
#include "support/temp_dir.hpp"

namespace deburr {
namespace {

using testing::HasSubstr;

TEST(Ply, RefusesCloudsThatContradictThemselves) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points.resize(2);
  const auto refused = [&](const PointCloud& c) {
    EXPECT_THROW((void)write_cloud(dir / "a.ply", c), std::invalid_argument);
    EXPECT_EQ(dir.count(), 0);
  };
  PointCloud wrong = cloud;
  wrong.normals.resize(1);
  refused(wrong);
  for (const Attribute& a :
       {Attribute{"a", std::vector<float>(3), {}}, Attribute{"a", std::vector<float>(2), {0, 2}},
        Attribute{"a", std::vector<float>(2), {0, 3, 2}},
        Attribute{"a", std::vector<float>(2), {0, 1, 1}},
        Attribute{"x", std::vector<float>(2), {}}}) {
    wrong = cloud;
    wrong.attributes = {a};
    refused(wrong);
  }
  wrong = cloud;
  wrong.attributes = {{"a", std::vector<float>(2), {}}, {"a", std::vector<int>(2), {}}};
  refused(wrong);
  wrong = cloud;
  wrong.layout.elements = {{"face", 1, {{"a", std::vector<float>(2), {}}}, false}};
  refused(wrong);
  EXPECT_THROW((void)write_cloud(dir / "a.docx", cloud), std::invalid_argument);
}

TEST(Ply, NamesTheLineOfABadHeader) {
  const std::string start = "ply\nformat ascii 1.0\nelement vertex 1\n";
  const auto expect = [&](const std::string& file, const std::string& message) {
    EXPECT_EQ(error_of(file), message);
  };
  expect(start + "prop float x\n", "line 4: unknown keyword 'prop' in the header");
  expect(start + "property half x\n", "line 4: unknown type 'half'");
  expect(start + "property float\n", "line 4: property without a name");
  expect(start + "property float x y\n", "line 4: unexpected 'y'");
  expect(start + "property list float int x\n", "line 4: the length of a list must be an integer");
  expect(start + xyz() + "property int x\n", "line 7: element 'vertex' has two properties 'x'");
  expect(start + "element vertex 2\n", "line 4: element 'vertex' appears twice");
  expect("ply\nformat ascii 2.0\n", "line 2: unknown version '2.0' of PLY");
  expect("ply\nformat morse 1.0\n", "line 2: unknown format 'morse'");
  expect("ply\nproperty float x\n", "line 2: property before the first element");
  for (const char* count : {"-1", "18446744073709551616", "1.5", "x", ""}) {
    expect("ply\nelement vertex " + std::string(count) + "\n",
           "line 2: bad number '" + std::string(count) + "' of items of element 'vertex'");
  }
  expect("ply\nelement vertex 0\n" + xyz() + "end_header\n",
         "line 6: the header has no format line");
  expect(start + xyz(), "line 6: the header does not end with end_header");
  expect("ply\nformat ascii 1.0\nelement face 0\nend_header\n", "the file has no element 'vertex'");
  expect(start + "property float x\nproperty float z\nend_header\n1 2\n",
         "element 'vertex' has no property 'y'");
}

TEST(Ply, NamesThePlaceOfABadRow) {
  const std::string list = xyz() + "property list char short a\n";
  EXPECT_EQ(error_of(ascii(xyz(), "1 2 3.5\n1 2.5\n", 2)),
            "line 9: the row ends before property 'z' of element 'vertex'");
  EXPECT_EQ(error_of(ascii(xyz(), "1 2 3 4\n")),
            "line 8: unexpected '4' behind the last property of element 'vertex'");
  EXPECT_EQ(error_of(ascii(xyz(), "1 2,5 3\n")), "line 8: '2,5' is no value for property 'y'");
  EXPECT_EQ(error_of(ascii(xyz(), "1 2 1e999\n")), "line 8: '1e999' is no value for property 'z'");
  EXPECT_EQ(error_of(ascii(list, "1 2 3 -1\n")), "line 9: list 'a' has length -1");
  EXPECT_EQ(error_of(ascii(list, "1 2 3 1 32768\n")),
            "line 9: '32768' is no value for property 'a'");
  EXPECT_EQ(error_of(ascii(xyz(), "1 2 3\n4 5 6\n", 3)),
            "byte 112: the file ends in row 3 of 3 of element 'vertex'");
  EXPECT_EQ(error_of(ascii(list, "1 2 3 1.0 4.0\n")), "");

  using namespace std::string_literals;
  const std::string binary = "ply\nformat binary_big_endian 1.0\nelement vertex 1\n"s + list +
                             "end_header\n" + std::string(12, '\0');
  EXPECT_EQ(error_of(binary + "\xff\0\0"s),
            "byte " + std::to_string(binary.size()) +
                ": a list of element 'vertex', row 1, has length -1");
  EXPECT_EQ(error_of(binary + "\x02\0\0\0"s),
            "byte " + std::to_string(binary.size() + 4) +
                ": the file ends in row 1 of 1 of element 'vertex'");
}

TEST(Ply, RefusesFacesThatPointBeyondTheVertices) {
  const auto file = [](const std::string& format, const std::string& data) {
    return "ply\nformat " + format + " 1.0\nelement vertex 2\n" + xyz() +
           "element face 2\nproperty uchar a\nproperty list uchar int vertex_indices\n"
           "property short b\nend_header\n" +
           data;
  };
  const std::string text = file("ascii", "0 0 0\n1 1 1\n\n7 2 0 1 8\n");
  const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  EXPECT_EQ(error_of(text + "7 0 8\n"), "");
  EXPECT_EQ(
      error_of(text + "\n7 3 0 1 2 8\n"),
      "line " + std::to_string(lines + 2) + ": face 2 has vertex 2, but there are 2 vertices");
  EXPECT_EQ(error_of(text + "7 1 -1 8\n"), "line " + std::to_string(lines + 1) +
                                               ": face 2 has vertex -1, but there are 2 vertices");
  using namespace std::string_literals;
  const std::string binary =
      file("binary_little_endian", std::string(24, '\0') + "\7\2\0\0\0\0\1\0\0\0\x8\0"s);
  EXPECT_EQ(error_of(binary + "\7\1\1\0\0\0\x8\0"s), "");
  EXPECT_EQ(error_of(binary + "\7\1\0\0\1\0\x8\0"s),
            "byte " + std::to_string(binary.size()) +
                ": face 2 has vertex 65536, but there are 2 vertices");
}

TEST(Ply, DoesNotBelieveHugeCounts) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* count : {"1099511627776", "9223372036854775807", "18446744073709551615"}) {
      const auto error = [&](const std::string& element, const std::string& rest) {
        std::string file = "ply\nformat ";
        file.append(format).append(" 1.0\nelement ").append(element).append(" ").append(count);
        return error_of(file.append("\n").append(rest));
      };
      const std::string claim = std::string("of ") + count + " of element ";
      const std::string end = "end_header\n1 2 3        \n";
      const std::string vertex = "element vertex 1\n" + xyz() + end;
      EXPECT_THAT(error("vertex", xyz() + end), HasSubstr(claim + "'vertex'"));
      EXPECT_THAT(error("a", "property list uchar int b\n" + vertex), HasSubstr(claim + "'a'"));
      // Rows without properties take no room.
      EXPECT_EQ(error("a", vertex), "");
    }
  }
  using namespace std::string_literals;
  EXPECT_THAT(error_of("ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + xyz() +
                       "property list uint double a\nend_header\n" + std::string(12, '\0') +
                       "\xff\xff\xff\xff"s + "1234567890"),
              HasSubstr("the file ends"));
}

TEST(Ply, EveryTruncationIsReadOrRefused) {
  const TempDir dir;
  for (const Encoding encoding : all_encodings) {
    PointCloud cloud = full_cloud(encoding);
    cloud.layout.elements.pop_back();
    (void)write_cloud(dir / "a.ply", cloud);
    const std::string file = get(dir / "a.ply");
    for (std::size_t length = 0; length < file.size(); ++length) {
      const std::string error = error_of(file.substr(0, length));
      // In a text, the last number may be cut, or only the line end after it.
      if (encoding != Encoding::PlyAscii || length + 20 < file.size()) {
        ASSERT_NE(error, "") << length << " of " << file.size();
      }
    }
  }
}

TEST(Ply, SurvivesRandomDamage) {
  const TempDir dir;
  for (const Encoding encoding : all_encodings) {
    (void)write_cloud(dir / "a.ply", full_cloud(encoding));
    fuzz(get(dir / "a.ply"), 1, 2500);
  }
}

TEST(Ply, StopsReadingWhenCancelled) {
  const TempDir dir;
  (void)write_cloud(dir / "a.ply", full_cloud(Encoding::PlyAscii));
  for (int stop = 1; stop <= 3; ++stop) {
    int left = stop;
    EXPECT_THROW((void)read_cloud(dir / "a.ply", [&] { return --left == 0; }), Cancelled);
  }
}

TEST(ReadCloud, NamesFilesThatCannotBeRead) {
  const TempDir dir;
  const auto message = [&](const std::filesystem::path& path) -> std::string {
    try {
      (void)read_cloud(path);
    } catch (const IoError& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(message(dir / "none.ply"), (dir / "none.ply").string() + ": No such file or directory");
  EXPECT_THAT(message(dir.path()), HasSubstr("Is a directory"));
  put(dir / "a.ply", "");
  EXPECT_THAT(message(dir / "a.ply"), HasSubstr("empty file"));
}

}  // namespace
}  // namespace deburr

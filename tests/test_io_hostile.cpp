// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <clocale>

#include "deburr/error.hpp"
#include "support/broken_files.hpp"
#include "support/cloud_files.hpp"
#include "support/comma_locale.hpp"
#include "support/las_files.hpp"
#include "support/same_cloud.hpp"

// Files that are cut off, damaged, or lie about their size; PLY and text have their own tests.

namespace deburr {
namespace {

using testing::HasSubstr;

struct SmallFile {
  std::string name;
  std::string format;
  std::string data;
};

/// Three points with some fields, or one face.
PointCloud small_cloud(Encoding encoding) {
  PointCloud cloud;
  cloud.points = {{1, 2, 3}, {4.5, 5, 6}, {7, 8.25, 9}};
  cloud.attributes = {{"red", std::vector<std::uint8_t>{1, 2, 255}, {}},
                      {"green", std::vector<std::uint8_t>{1, 2, 255}, {}},
                      {"blue", std::vector<std::uint8_t>{1, 2, 255}, {}},
                      {"time", std::vector<double>{0.1, 0.2, 1e300}, {}}};
  cloud.layout.encoding = encoding;
  cloud.layout.blocks = {{"PCD colour", "rgb"}};
  return cloud;
}

std::string pcd(Encoding encoding) {
  const TempDir dir;
  return written_as(dir, small_cloud(encoding), "a.pcd");
}

std::string stl() {
  const TempDir dir;
  PointCloud cloud = parsed("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  return written_as(dir, cloud, "a.stl");
}

LasParts modern_las() {
  LasParts parts{.minor = 4, .format = 7, .points = 3};
  parts.records =
      las_record("LASF_Spec", 4, las_descriptor("a", 9) + las_descriptor("b", 3, 24, 0.5, 2)) +
      las_record("x", 1, "yz");
  parts.record_count = 2;
  parts.extra_bytes = 7;
  parts.extended = las_record("someone", 7, "big", true);
  parts.extended_count = 1;
  return parts;
}

std::vector<SmallFile> small_files() {
  return {{"las", "las", las_file({.points = 3})},
          {"las14", "las", las_file(modern_las())},
          {"pcd_ascii", "pcd", pcd(Encoding::PcdAscii)},
          {"pcd_binary", "pcd", pcd(Encoding::PcdBinary)},
          {"pcd_compressed", "pcd", pcd(Encoding::PcdCompressed)},
          {"obj", "obj",
           "# c\nmtllib a\nv 1 2 3 0.5 0 1\nv 4 5 6 1 1 1\nv 7 8 9 0 0 0\nvt 0 1\nvn 0 0 1\n"
           "f 1/1/1 2/1/1 3/1/1\nf -1//1 1//1 -2//1\n"},
          {"off", "off",
           "CNOFF\n# c\n3 2 0\n1 2 3 0 0 1 255 0 7\n4 5 6 0 1 0 1 2 3\n7 8 9 1 0 0 9 9 9\n"
           "3 0 1 2\n4 2 1 0 1 0.5 0.25 0.125\n"},
          {"stl", "stl", stl()},
          {"stl_ascii", "stl",
           "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
           "endloop\nendfacet\nendsolid a\n"}};
}

/// The error of reading as this format; "" if it can be read.
std::string error_as(const std::string& data, const std::string& format) {
  try {
    const PointCloud cloud = parsed(data, format);
    EXPECT_TRUE(cloud.normals.empty() || cloud.normals.size() == cloud.size());
    return "";
  } catch (const IoError& e) {
    return e.what();
  }
}

constexpr std::size_t small_file_count = 9;

class Hostile : public testing::TestWithParam<std::size_t> {
 protected:
  const std::vector<SmallFile> all = small_files();
  const SmallFile& file = all.at(GetParam());
};

TEST(SmallFiles, KnowsHowManyFilesThereAre) { EXPECT_EQ(small_files().size(), small_file_count); }

TEST_P(Hostile, EveryTruncationIsReadOrRefused) {
  int refused = 0;
  for (std::size_t length = 0; length < file.data.size(); ++length) {
    const std::string error = error_as(file.data.substr(0, length), file.format);
    refused += error.empty() ? 0 : 1;
    (void)error_of(file.data.substr(0, length));
    if (error.empty()) continue;
    EXPECT_THAT(error, testing::MatchesRegex("given: .*(byte|line|empty|no vertices|DATA).*"));
  }
  // Of a text, the last line may be cut off or end early.
  const bool is_text = file.name.ends_with("ascii") || file.format == "obj" || file.format == "off";
  EXPECT_GT(refused, is_text ? 0 : static_cast<int>(file.data.size()) - 1);
}

TEST_P(Hostile, SurvivesRandomDamage) { fuzz(file.data, 5, 1000); }

// What is read can be written, and is then read as the same.
TEST_P(Hostile, WritesWhateverItAccepts) {
  const TempDir dir;
  std::mt19937 random(7);
  int accepted = 0;
  for (int run = 0; run < 80; ++run) {
    std::string data = file.data;
    for (int n = 0; n < 1 + run % 3; ++n) {
      const std::size_t at = random() % data.size();
      data[at] = static_cast<char>(run % 2 == 0 ? '0' + random() % 10 : random() % 256);
    }
    PointCloud cloud;
    try {
      cloud = parsed(data, file.format);
    } catch (const IoError&) {
      continue;
    }
    SCOPED_TRACE(run);
    try {
      (void)write_cloud(dir / ("a." + file.format), cloud);
    } catch (const DataError&) {
      continue;  // infinite coordinates in LAS
    }
    ++accepted;
    const PointCloud again = read_cloud(dir / ("a." + file.format));
    EXPECT_TRUE(same_values(again.points, cloud.points));
    EXPECT_TRUE(same_values(again.normals, cloud.normals));
    expect_same(again.attributes, cloud.attributes);
  }
  EXPECT_GT(accepted, 5);
}

// Whatever the eight bytes at any place say, no memory is taken on their word.
TEST_P(Hostile, TakesNoMemoryOnTheWordOfAHeader) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &before), 0);
#ifdef __SANITIZE_ADDRESS__
  const rlimit small = before;  // the sanitizer itself needs more
#else
  const rlimit small{std::size_t{1} << 28, before.rlim_max};
#endif
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &small), 0);
  for (const char byte : {'\x7f', '\xff', '9'}) {
    for (const std::size_t size : {2U, 4U, 8U}) {
      for (std::size_t at = 0; at + size < file.data.size(); ++at) {
        std::string data = file.data;
        data.replace(at, size, size, byte);
        (void)error_as(data, file.format);
      }
    }
  }
  EXPECT_EQ(setrlimit(RLIMIT_DATA, &before), 0);
}

INSTANTIATE_TEST_SUITE_P(Files, Hostile, testing::Range(std::size_t{0}, small_file_count));

TEST(Lines, EndInEveryWay) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    SCOPED_TRACE(static_cast<int>(end[0]));
    const std::string rows = "1 2 3" + end + "4 5 6" + end;
    const std::string head = "ply" + end + "format ascii 1.0" + end + "element vertex 2" + end +
                             "property float x" + end + "property float y" + end +
                             "property float z" + end + "end_header" + end;
    for (const std::string& file :
         {rows, head + rows, "OFF" + end + "2 0 0" + end + rows, "v 1 2 3" + end + "v 4 5 6" + end,
          "VERSION .7" + end + "FIELDS x y z" + end + "SIZE 4 4 4" + end + "TYPE F F F" + end +
              "POINTS 2" + end + "DATA ascii" + end + rows}) {
      EXPECT_EQ(error_of(file), "") << file;
      EXPECT_EQ(parsed(file).points, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}})) << file;
    }
  }
  EXPECT_EQ(parsed("1 2 3\r\n4 5 6\n7 8 9\r\n").size(), 3U);
  EXPECT_EQ(error_of("1 2 3\n4 5 6\r7 8 9\n"), "line 2: 6 columns, but 3 before");
}

TEST(Paths, MayHaveBlanksAndLettersOfAnyLanguage) {
  const TempDir dir;
  for (const std::string& format : format_names()) {
    const std::string name = "Prüf teil 点群 \"a\"." + format;
    PointCloud cloud = parsed("OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n");
    (void)write_cloud(dir / name, cloud);
    EXPECT_EQ(read_cloud(dir / name).size(), 3U) << name;
  }
}

// A program that uses the library may have set a locale with a decimal comma.
TEST(Locale, PlaysNoRole) {
  const std::vector<SmallFile> files = small_files();
  const TempDir dir;
  if (!set_comma_locale(dir.path())) {
    GTEST_SKIP() << "NOT TESTED: no locale with a decimal comma is installed or can be made";
  }
  const std::string comma = std::setlocale(LC_ALL, nullptr);
  for (const SmallFile& file : files) {
    ASSERT_NE(std::setlocale(LC_ALL, comma.c_str()), nullptr);
    const PointCloud cloud = parsed(file.data, file.format);
    const std::string here = written_as(dir, cloud, "a." + file.format);
    ASSERT_NE(std::setlocale(LC_ALL, "C"), nullptr);
    EXPECT_EQ(here, written_as(dir, parsed(file.data, file.format), "a." + file.format));
  }
}

}  // namespace
}  // namespace deburr

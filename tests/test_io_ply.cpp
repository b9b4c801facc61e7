// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <bit>
#include <random>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "support/ply_files.hpp"
#include "support/same_cloud.hpp"
#include "support/temp_dir.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Ply, KeepsEverythingInEveryEncoding) {
  const TempDir dir;
  for (const Encoding encoding : all_encodings) {
    SCOPED_TRACE(static_cast<int>(encoding));
    const PointCloud cloud = full_cloud(encoding);
    EXPECT_THAT(write_cloud(dir / "a.ply", cloud), IsEmpty());
    const PointCloud again = read_cloud(dir / "a.ply");
    expect_same(again, cloud);
    (void)write_cloud(dir / "b.ply", again);
    EXPECT_EQ(get(dir / "a.ply"), get(dir / "b.ply"));
  }
}

TEST(Ply, ScalarOnlyPathEqualsTheGeneralOne) {
  const TempDir dir;
  for (const Encoding encoding : all_encodings) {
    PointCloud cloud = full_cloud(encoding);
    std::erase_if(cloud.attributes, [](const Attribute& a) { return a.is_list(); });
    std::erase_if(cloud.layout.fields, [](const Field& f) { return f.name.ends_with("list"); });
    (void)write_cloud(dir / "a.ply", cloud);
    expect_same(read_cloud(dir / "a.ply"), cloud);
  }
}

TEST(Ply, CrossesBlocks) {
  const TempDir dir;
  PointCloud cloud;
  std::vector<std::int16_t> ids;
  for (int i = 0; i < 10000; ++i) {
    cloud.points.push_back({0.1 * i, -i / 3.0, 1e-9 * i});
    ids.push_back(static_cast<std::int16_t>(i));
  }
  cloud.attributes = {{"id", ids, {}}};
  for (const Encoding encoding : all_encodings) {
    cloud.layout.encoding = encoding;
    (void)write_cloud(dir / "a.ply", cloud);
    const PointCloud again = read_cloud(dir / "a.ply");
    EXPECT_EQ(again.points, cloud.points);
    EXPECT_EQ(again.attributes[0].values, cloud.attributes[0].values);
  }
}

TEST(Ply, WritesTheseBytes) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{1, 2, -2}};
  cloud.attributes = {{"red", std::vector<std::uint8_t>{7}, {}},
                      {"near", std::vector<std::uint16_t>{1, 258}, {0, 2}, ScalarType::UInt8}};
  cloud.layout.comments = {"hello"};
  cloud.layout.fields = {
      {"x", ScalarType::Float32}, {"y", ScalarType::Float32}, {"z", ScalarType::Float32}};
  const auto header = [](const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment hello\nelement vertex 1\nproperty float x\nproperty float y\n"
           "property float z\nproperty uchar red\nproperty list uchar ushort near\nend_header\n";
  };
  using namespace std::string_literals;
  (void)write_cloud(dir / "a.ply", cloud);
  EXPECT_EQ(get(dir / "a.ply"), header("binary_little_endian") +
                                    "\0\0\x80\x3f\0\0\0\x40\0\0\0\xc0\x07\x02\x01\0\x02\x01"s);
  cloud.layout.encoding = Encoding::PlyBigEndian;
  (void)write_cloud(dir / "a.ply", cloud);
  EXPECT_EQ(get(dir / "a.ply"), header("binary_big_endian") +
                                    "\x3f\x80\0\0\x40\0\0\0\xc0\0\0\0\x07\x02\0\x01\x01\x02"s);
  cloud.layout.encoding = Encoding::PlyAscii;
  (void)write_cloud(dir / "a.ply", cloud);
  EXPECT_EQ(get(dir / "a.ply"), header("ascii") + "1 2 -2 7 2 1 258\n");
}

TEST(Ply, ReadsAllNamesOfTypes) {
  const TempDir dir;
  const char* const names[][2] = {{"char", "int8"},     {"uchar", "uint8"},   {"short", "int16"},
                                  {"ushort", "uint16"}, {"int", "int32"},     {"uint", "uint32"},
                                  {"float", "float32"}, {"double", "float64"}};
  const ScalarType types[] = {ScalarType::Int8,    ScalarType::UInt8,  ScalarType::Int16,
                              ScalarType::UInt16,  ScalarType::Int32,  ScalarType::UInt32,
                              ScalarType::Float32, ScalarType::Float64};
  for (std::size_t k = 0; k < 8; ++k) {
    for (const char* name : names[k]) {
      put(dir / "a", ascii(xyz() + "property " + name + " a\n", "1 2 3 4\n"));
      EXPECT_EQ(read_cloud(dir / "a").attributes.at(0).type(), types[k]) << name;
    }
  }
}

TEST(Ply, ReadsLooseHeaders) {
  const TempDir dir;
  const std::string file =
      "ply\r\nformat ascii 1.0  \r\ncomment\r\n\r\ncomment   indented\r\nobj_info a b\r\n"
      "element vertex 2 \r\nproperty float32 x\r\nproperty\tfloat y\r\nproperty float z\r\n"
      "end_header\r\n1 2 3\r\n\r\n  4\t5  6 \r\n\r\n";
  put(dir / "a", file);
  const PointCloud cloud = read_cloud(dir / "a");
  EXPECT_THAT(cloud.points, ElementsAre(Vec3{1, 2, 3}, Vec3{4, 5, 6}));
  EXPECT_THAT(cloud.layout.comments, ElementsAre("", "  indented"));
  EXPECT_THAT(cloud.layout.obj_info, ElementsAre("a b"));

  using namespace std::string_literals;
  put(dir / "a", "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 1\r\n"s + xyz() +
                     "end_header\r\n" + "\0\0\x80\x3f\0\0\0\x40\0\0\0\xc0"s + "\ntrailing");
  EXPECT_THAT(read_cloud(dir / "a").points, ElementsAre(Vec3{1, 2, -2}));
}

TEST(Ply, ReadsTextAsDoublesWhateverIsDeclared) {
  const TempDir dir;
  put(dir / "a", ascii("property float x\nproperty int y\nproperty float z\n",
                       "500000.123456789 2.5 -NaN\n+1 INF -inf\n1e-400 -1e-400 5e-324\n", 3));
  const PointCloud cloud = read_cloud(dir / "a");
  EXPECT_EQ(cloud.points[0].x, 500000.123456789);
  EXPECT_EQ(cloud.points[0].y, 2.5);
  EXPECT_TRUE(std::isnan(cloud.points[0].z) && std::signbit(cloud.points[0].z));
  EXPECT_EQ(cloud.points[1], (Vec3{1, inf, -inf}));
  EXPECT_TRUE(same_bits(cloud.points[2], Vec3{0, -0.0, 5e-324}));
  (void)write_cloud(dir / "b.ply", cloud);
  const PointCloud again = read_cloud(dir / "b.ply");
  EXPECT_TRUE(same_values(again.points, cloud.points));
  EXPECT_EQ(again.layout.fields[1], (Field{"y", ScalarType::Float64}));
}

// Such numbers were floats, and stay so in a text; in binary their doubles need doubles.
TEST(Ply, KeepsDecimalFloatsInText) {
  const TempDir dir;
  const std::string file =
      ascii(xyz(), "0.1 -12.345678 0.1234567836\n3.4028235e+38 0.00012 7\n", 2);
  put(dir / "a.ply", file);
  PointCloud cloud = read_cloud(dir / "a.ply");
  (void)write_cloud(dir / "b.ply", cloud);
  EXPECT_EQ(get(dir / "b.ply"), file);
  cloud.layout.encoding = Encoding::PlyBigEndian;
  (void)write_cloud(dir / "b.ply", cloud);
  EXPECT_EQ(read_cloud(dir / "b.ply").points, cloud.points);
  EXPECT_EQ(read_cloud(dir / "b.ply").layout.fields[0].type, ScalarType::Float64);
}

TEST(Ply, KeepsTheTypeOfCoordinatesWhereItIsExact) {
  const TempDir dir;
  const auto types_after = [&](Vec3 point, ScalarType type, Encoding encoding) {
    PointCloud cloud;
    cloud.points = {{1, 2, 3}, point};
    cloud.layout.encoding = encoding;
    for (const char* name : {"x", "y", "z"}) cloud.layout.fields.push_back({name, type});
    (void)write_cloud(dir / "a.ply", cloud);
    const PointCloud again = read_cloud(dir / "a.ply");
    EXPECT_TRUE(same_values(again.points, cloud.points));
    EXPECT_EQ(again.layout.fields[0].type, again.layout.fields[1].type);
    EXPECT_EQ(again.layout.fields[0].type, again.layout.fields[2].type);
    return again.layout.fields[0].type;
  };
  for (const Encoding e : all_encodings) {
    const bool text = e == Encoding::PlyAscii;
    const auto wide = ScalarType::Float64;
    EXPECT_EQ(types_after({0.5, nan, -inf}, ScalarType::Float32, e), ScalarType::Float32);
    EXPECT_EQ(types_after({0.1, 0, 0}, ScalarType::Float32, e), text ? ScalarType::Float32 : wide);
    EXPECT_EQ(types_after({500000.123456789, 0, 0}, ScalarType::Float32, e), wide);
    EXPECT_EQ(types_after({0, 1e39, 0}, ScalarType::Float32, e), wide);
    EXPECT_EQ(types_after({0, 1e-50, 0}, ScalarType::Float32, e), wide);
    EXPECT_EQ(types_after({-32768, 32767, 0}, ScalarType::Int16, e), ScalarType::Int16);
    EXPECT_EQ(types_after({100000, 4294967295, 0}, ScalarType::UInt32, e), ScalarType::UInt32);
    for (const double v : {32768.0, 0.5, nan, inf, -0.0}) {
      EXPECT_EQ(types_after({0, 0, v}, ScalarType::Int16, e), wide) << v;
    }
    EXPECT_EQ(types_after({1, 2, 3}, ScalarType::Int64, e), wide);
  }
}

// PCD has coordinates that are integers of 64 bits, PLY has not, be there points or none.
TEST(Ply, WritesCoordinatesOfTypesThatItHasNotAsDoubles) {
  const TempDir dir;
  for (const std::size_t points : {0U, 2U}) {
    PointCloud cloud;
    cloud.points.assign(points, {1, 2, 3});
    for (const char* name : {"x", "y", "z"}) {
      cloud.layout.fields.push_back({name, ScalarType::UInt64});
    }
    (void)write_cloud(dir / "a.ply", cloud);
    EXPECT_EQ(read_cloud(dir / "a.ply").points, cloud.points);
    EXPECT_THAT(get(dir / "a.ply"), testing::HasSubstr("property double z\n"));
  }
}

TEST(Ply, KeepsRandomDoublesExactly) {
  const TempDir dir;
  std::mt19937_64 random(1);
  PointCloud cloud;
  for (int i = 0; i < 3000; ++i) {
    const auto number = [&] {
      // Every third point is made of denormals.
      const auto value = std::bit_cast<double>(random() >> (i % 3 == 0 ? 12 : 0));
      return std::isnan(value) ? 500000.123456789 + i : value;
    };
    cloud.points.push_back({number(), number(), number()});
  }
  for (const char* name : {"a.ply", "a.xyz", "a.csv"}) {
    for (const Encoding encoding : all_encodings) {
      cloud.layout.encoding = encoding;
      (void)write_cloud(dir / name, cloud);
      EXPECT_TRUE(same_values(read_cloud(dir / name).points, cloud.points)) << name;
    }
  }
}

TEST(Ply, NarrowsIntegersThatItHasNoTypeFor) {
  const TempDir dir;
  using I = std::vector<std::int64_t>;
  using U = std::vector<std::uint64_t>;
  const auto type_of = [&](const Values& values) {
    PointCloud cloud;
    cloud.points = {{0, 0, 0}, {1, 1, 1}};
    cloud.attributes = {{"a", values, {}}};
    EXPECT_THAT(write_cloud(dir / "a.ply", cloud), IsEmpty());
    return read_cloud(dir / "a.ply").attributes.at(0).type();
  };
  EXPECT_EQ(type_of(I{0, 255}), ScalarType::UInt8);
  EXPECT_EQ(type_of(I{-1, 127}), ScalarType::Int8);
  EXPECT_EQ(type_of(I{-1, 128}), ScalarType::Int16);
  EXPECT_EQ(type_of(U{0, 65535}), ScalarType::UInt16);
  EXPECT_EQ(type_of(I{0, 65536}), ScalarType::UInt32);
  EXPECT_EQ(type_of(I{-1, 65536}), ScalarType::Int32);
  EXPECT_EQ(type_of(I{0, (std::int64_t{1} << 53)}), ScalarType::Float64);
  EXPECT_EQ(type_of(U{0, std::uint64_t{1} << 63}), ScalarType::Float64);
}

TEST(Ply, SaysWhatItCannotHold) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{0, 0, 0}};
  cloud.attributes = {
      {"name", std::vector<std::string>{"car"}, {}},
      {"id", std::vector<std::int64_t>{(std::int64_t{1} << 53) + 1}, {}},
      {"max", std::vector<std::uint64_t>{std::numeric_limits<std::uint64_t>::max()}, {}},
      {"good", std::vector<float>{1}, {}}};
  EXPECT_THAT(write_cloud(dir / "a.ply", cloud),
              ElementsAre("PLY cannot hold the text 'name', which was left out",
                          "PLY cannot hold the integers 'id', which were left out",
                          "PLY cannot hold the integers 'max', which were left out"));
  EXPECT_EQ(read_cloud(dir / "a.ply").attributes.size(), 1U);
}

TEST(Ply, WidensTheLengthOfLongLists) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{0, 0, 0}};
  cloud.attributes = {{"a", std::vector<float>(300), {0, 300}, ScalarType::UInt8}};
  (void)write_cloud(dir / "a.ply", cloud);
  const Attribute again = read_cloud(dir / "a.ply").attributes.at(0);
  EXPECT_EQ(again.length_type, ScalarType::UInt16);
  EXPECT_THAT(again.offsets, ElementsAre(0, 300));
}

TEST(Ply, AddsNewFieldsBehindTheOldOnes) {
  const TempDir dir;
  put(dir / "a.ply", ascii("property uchar red\n" + xyz(), "9 1 2 3\n"));
  PointCloud cloud = read_cloud(dir / "a.ply");
  cloud.normals = {{0, 0, 1}};
  cloud.attributes.push_back({"my label", std::vector<std::uint8_t>{2}, {}});
  cloud.attributes.push_back({"my_label", std::vector<std::uint8_t>{3}, {}});
  (void)write_cloud(dir / "a.ply", cloud);
  EXPECT_EQ(get(dir / "a.ply"),
            ascii("property uchar red\n" + xyz() +
                      "property double nx\nproperty double ny\nproperty double nz\n"
                      "property uchar my_label\nproperty uchar my_label_\n",
                  "9 1 2 3 0 0 1 2 3\n"));
}

TEST(Ply, LeavesOutFieldsThatAreGone) {
  const TempDir dir;
  PointCloud cloud = full_cloud(Encoding::PlyAscii);
  cloud.normals.clear();
  cloud.attributes.clear();
  (void)write_cloud(dir / "a.ply", cloud);
  EXPECT_THAT(read_cloud(dir / "a.ply").layout.fields,
              ElementsAre(Field{"y"}, Field{"z"}, Field{"x"}));
}

// Memory for what these claim does not exist.
TEST(Ply, ReadsNoPoints) {
  const TempDir dir;
  for (const Encoding encoding : all_encodings) {
    PointCloud cloud;
    cloud.layout.encoding = encoding;
    cloud.layout.fields = {{"x"}, {"y"}, {"z"}};
    (void)write_cloud(dir / "a.ply", cloud);
    expect_same(read_cloud(dir / "a.ply"), cloud);
  }
}

}  // namespace
}  // namespace deburr

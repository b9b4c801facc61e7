// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <bit>
#include <limits>
#include <random>

#include "deburr/error.hpp"
#include "deburr/io.hpp"
#include "support/broken_files.hpp"
#include "support/same_cloud.hpp"
#include "support/temp_dir.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr Encoding all_encodings[] = {Encoding::PlyAscii, Encoding::PlyLittleEndian,
                                      Encoding::PlyBigEndian};
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <typename T>
std::vector<T> extremes() {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_floating_point_v<T>) {
    return {Limits::denorm_min(), Limits::lowest(),    Limits::max(),      T(0.1), -T(0),
            Limits::infinity(),   Limits::quiet_NaN(), -Limits::infinity()};
  } else {
    return {Limits::min(), Limits::max(), 0, 1, 2, 3, 4, 100};
  }
}

template <typename T>
void add_type(std::vector<Attribute>& to, const std::string& name, ScalarType length_type) {
  to.push_back({name, extremes<T>(), {}});
  to.push_back({name + "_list", extremes<T>(), {0, 0, 3, 3, 4, 8, 8, 8, 8}, length_type});
}

/// Eight items with a value and a list of every type.
std::vector<Attribute> every_type() {
  std::vector<Attribute> all;
  add_type<std::int8_t>(all, "i8", ScalarType::Int8);
  add_type<std::uint8_t>(all, "u8", ScalarType::UInt8);
  add_type<std::int16_t>(all, "i16", ScalarType::Int16);
  add_type<std::uint16_t>(all, "u16", ScalarType::UInt16);
  add_type<std::int32_t>(all, "i32", ScalarType::Int32);
  add_type<std::uint32_t>(all, "u32", ScalarType::UInt32);
  add_type<float>(all, "f32", ScalarType::UInt8);
  add_type<double>(all, "f64", ScalarType::UInt8);
  return all;
}

/// Eight points with everything that a PLY file can hold.
PointCloud full_cloud(Encoding encoding) {
  PointCloud cloud;
  const std::vector<double> values = extremes<double>();
  for (std::size_t i = 0; i < 8; ++i) {
    cloud.points.push_back({values[i], 500000.123456789, 0.1 * static_cast<double>(i)});
    cloud.normals.push_back({0, 0.5, i % 2 == 0 ? nan : inf});
  }
  cloud.attributes = every_type();
  cloud.layout.encoding = encoding;
  // Order is that of the file: here neither coordinates nor normals stand together.
  cloud.layout.fields = {{"nz", ScalarType::Float32}, {"y", ScalarType::Float64}};
  for (const Attribute& a : cloud.attributes) cloud.layout.fields.push_back({a.name, a.type()});
  for (const char* name : {"z", "x"}) cloud.layout.fields.push_back({name, ScalarType::Float64});
  for (const char* name : {"nx", "ny"}) cloud.layout.fields.push_back({name, ScalarType::Float32});
  cloud.layout.comments = {"made by hand", "", "two  blanks, and = marks"};
  cloud.layout.obj_info = {"num_cols 4", "num_rows 2"};
  cloud.layout.elements = {{"camera", 8, every_type(), true},
                           {"nothing", 5, {}, true},
                           {"face", 8, every_type(), false},
                           {"none", 0, {{"a", std::vector<float>{}, {}}}, false}};
  return cloud;
}

/// A file with the vertex properties and rows given, in ASCII.
std::string ascii(const std::string& properties, const std::string& rows, int count = 1) {
  return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(count) + "\n" + properties +
         "end_header\n" + rows;
}
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";

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
      put(dir / "a", ascii(xyz + "property " + name + " a\n", "1 2 3 4\n"));
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
  put(dir / "a", "ply\r\nformat binary_little_endian 1.0\r\nelement vertex 1\r\n"s + xyz +
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
  const std::string file = ascii(xyz, "0.1 -12.345678 0.1234567836\n3.4028235e+38 0.00012 7\n", 2);
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

TEST(Ply, KeepsRandomDoublesExactly) {
  const TempDir dir;
  std::mt19937_64 random(1);
  PointCloud cloud;
  for (int i = 0; i < 3000; ++i) {
    Vec3 p;
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      p.*axis = std::bit_cast<double>(random() >> (i % 3 == 0 ? 12 : 0));  // denormals as well
      if (std::isnan(p.*axis)) p.*axis = 500000.123456789 + i;
    }
    cloud.points.push_back(p);
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
                          "PLY cannot hold the integers 'id', which was left out",
                          "PLY cannot hold the integers 'max', which was left out"));
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
  put(dir / "a.ply", ascii("property uchar red\n" + xyz, "9 1 2 3\n"));
  PointCloud cloud = read_cloud(dir / "a.ply");
  cloud.normals = {{0, 0, 1}};
  cloud.attributes.push_back({"my label", std::vector<std::uint8_t>{2}, {}});
  cloud.attributes.push_back({"my_label", std::vector<std::uint8_t>{3}, {}});
  (void)write_cloud(dir / "a.ply", cloud);
  EXPECT_EQ(get(dir / "a.ply"),
            ascii("property uchar red\n" + xyz +
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
  EXPECT_THROW((void)write_cloud(dir / "a.las", cloud), std::invalid_argument);
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
  expect(start + xyz + "property int x\n", "line 7: element 'vertex' has two properties 'x'");
  expect(start + "element vertex 2\n", "line 4: element 'vertex' appears twice");
  expect("ply\nformat ascii 2.0\n", "line 2: unknown version '2.0' of PLY");
  expect("ply\nformat morse 1.0\n", "line 2: unknown format 'morse'");
  expect("ply\nproperty float x\n", "line 2: property before the first element");
  for (const char* count : {"-1", "18446744073709551616", "1.5", "x", ""}) {
    expect("ply\nelement vertex " + std::string(count) + "\n",
           "line 2: bad number '" + std::string(count) + "' of items of element 'vertex'");
  }
  expect("ply\nelement vertex 0\n" + xyz + "end_header\n", "line 6: the header has no format line");
  expect(start + xyz, "line 6: the header does not end with end_header");
  expect("ply\nformat ascii 1.0\nelement face 0\nend_header\n", "the file has no element 'vertex'");
  expect(start + "property float x\nproperty float z\nend_header\n1 2\n",
         "element 'vertex' has no property 'y'");
}

TEST(Ply, NamesThePlaceOfABadRow) {
  const std::string list = xyz + "property list char short a\n";
  EXPECT_EQ(error_of(ascii(xyz, "1 2 3.5\n1 2.5\n", 2)),
            "line 9: the row ends before property 'z' of element 'vertex'");
  EXPECT_EQ(error_of(ascii(xyz, "1 2 3 4\n")),
            "line 8: unexpected '4' behind the last property of element 'vertex'");
  EXPECT_EQ(error_of(ascii(xyz, "1 2,5 3\n")), "line 8: '2,5' is no value for property 'y'");
  EXPECT_EQ(error_of(ascii(xyz, "1 2 1e999\n")), "line 8: '1e999' is no value for property 'z'");
  EXPECT_EQ(error_of(ascii(list, "1 2 3 -1\n")), "line 9: list 'a' has length -1");
  EXPECT_EQ(error_of(ascii(list, "1 2 3 1 32768\n")),
            "line 9: '32768' is no value for property 'a'");
  EXPECT_EQ(error_of(ascii(xyz, "1 2 3\n4 5 6\n", 3)),
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

// Memory for what these claim does not exist.
TEST(Ply, DoesNotBelieveHugeCounts) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* count : {"1099511627776", "9223372036854775807", "18446744073709551615"}) {
      const std::string start = "ply\nformat " + std::string(format) + " 1.0\n";
      const std::string vertex = "element vertex 1\n" + xyz;
      const std::string end = "end_header\n1 2 3 4 5 6 7 8 9\n";
      const std::string n(count);
      EXPECT_THAT(error_of(start + "element vertex " + n + "\n" + xyz + end),
                  HasSubstr("of " + n + " of element 'vertex'"));
      EXPECT_THAT(
          error_of(start + "element a " + n + "\nproperty list uchar int b\n" + vertex + end),
          HasSubstr("of " + n + " of element 'a'"));
      // Rows without properties take no room.
      EXPECT_EQ(
          error_of(start + "element a " + n + "\n" + vertex + "end_header\n" + "1 2 3        \n"),
          "");
    }
  }
  using namespace std::string_literals;
  EXPECT_THAT(error_of("ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + xyz +
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

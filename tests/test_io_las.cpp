// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "deburr/error.hpp"
#include "support/broken_files.hpp"
#include "support/cloud_files.hpp"
#include "support/las_files.hpp"
#include "support/same_cloud.hpp"

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Versions that may have the format.
std::vector<unsigned> versions_of(unsigned format) {
  if (format >= 6) return {4};
  if (format >= 4) return {3, 4};
  if (format >= 2) return {2, 3, 4};
  return {0, 1, 2, 3, 4};
}

TEST(Las, WritesEveryFormatBackBitByBit) {
  const TempDir dir;
  for (unsigned format = 0; format <= 10; ++format) {
    for (const unsigned minor : versions_of(format)) {
      SCOPED_TRACE(testing::Message() << "1." << minor << " format " << format);
      LasParts parts{.minor = minor, .format = format};
      parts.gap = "\xdd\xcc";
      if (minor == 4) {
        parts.extended = las_record("someone", 7, "big", true) + las_record("else", 8, "", true);
        parts.extended_count = 2;
      }
      const std::string file = las_file(parts);
      std::vector<std::string> warnings;
      EXPECT_EQ(without_box(written_as(dir, parsed(file), "a.las", &warnings)), file);
      EXPECT_THAT(warnings, IsEmpty());
    }
  }
}

// Version 1.3 has one record behind the points, whatever its name, and a place for where it is.
TEST(Las, MovesTheRecordBehindThePointsOfVersion13) {
  const TempDir dir;
  std::string file = las_file({.minor = 3, .format = 4});
  put_at(file, 227, static_cast<std::uint64_t>(file.size()));
  file += las_record("someone", 7, "big", true);
  PointCloud cloud = parsed(file);
  cloud.layout.comments = {"makes the part before the points longer"};
  const PointCloud again = parsed(written_as(dir, cloud, "a.las"));
  const HeaderBlock& record = again.layout.blocks.back();
  EXPECT_EQ(record.name, "LAS extended record someone 7");
  EXPECT_EQ(record.data, cloud.layout.blocks.back().data);
  expect_same(again.attributes, cloud.attributes);
}

TEST(Las, GivesFieldsOfOneNameNamesOfTheirOwn) {
  const TempDir dir;
  for (const std::size_t points : {0U, 3U}) {
    std::string descriptors;
    for (const char* name : {"nx", "ny", "nz", "nx", "a", "a"}) {
      descriptors += las_descriptor(name, 1);
    }
    const PointCloud cloud = parsed(las_file(
        {.points = points, .records = las_record("LASF_Spec", 4, descriptors), .extra_bytes = 6}));
    EXPECT_EQ(cloud.normals.size(), points);
    for (const char* name : {"nx_", "a", "a_"}) {
      EXPECT_EQ(values_of<std::uint8_t>(cloud, name).size(), points) << name;
    }
    const PointCloud again = parsed(written_as(dir, cloud, "a.las"));
    ASSERT_EQ(again.attributes.size(), cloud.attributes.size());
    // Without points there are no normals, and their names are free.
    if (points > 0) expect_same(again.attributes, cloud.attributes);
  }
}

TEST(Las, FindsTheFieldsOfTheSpecification) {
  LasParts parts{.minor = 4, .format = 8, .points = 1, .record_count = 0};
  parts.records.clear();
  std::string point(38, '\0');
  put_at(point, 0, std::int32_t{-100});
  put_at(point, 12, std::uint16_t{65535});
  point[14] = static_cast<char>(0x52);  // second of five returns
  point[15] = static_cast<char>(0x9a);  // key_point, overlap, channel 1, edge
  put_at(point, 16, std::uint8_t{200});
  put_at(point, 17, std::uint8_t{3});
  put_at(point, 18, std::int16_t{-30000});
  put_at(point, 20, std::uint16_t{9});
  put_at(point, 22, 123456789.123456789);
  for (std::uint16_t k = 0; k < 4; ++k)
    put_at(point, 30 + 2 * k, static_cast<std::uint16_t>(k + 1));
  const PointCloud cloud = parsed(las_file(parts, point));
  EXPECT_THAT(cloud.points, ElementsAre(Vec3{-1 + 500000.0, 500000, 500000}));
  const auto byte = [&](const char* name) { return values_of<std::uint8_t>(cloud, name).at(0); };
  EXPECT_EQ(values_of<std::uint16_t>(cloud, "intensity").at(0), 65535);
  EXPECT_EQ(byte("return_number"), 2);
  EXPECT_EQ(byte("number_of_returns"), 5);
  EXPECT_EQ(byte("synthetic"), 0);
  EXPECT_EQ(byte("key_point"), 1);
  EXPECT_EQ(byte("withheld"), 0);
  EXPECT_EQ(byte("overlap"), 1);
  EXPECT_EQ(byte("scanner_channel"), 1);
  EXPECT_EQ(byte("scan_direction_flag"), 0);
  EXPECT_EQ(byte("edge_of_flight_line"), 1);
  EXPECT_EQ(byte("classification"), 200);
  EXPECT_EQ(byte("user_data"), 3);
  EXPECT_EQ(values_of<std::int16_t>(cloud, "scan_angle").at(0), -30000);
  EXPECT_EQ(values_of<std::uint16_t>(cloud, "point_source_id").at(0), 9);
  EXPECT_EQ(values_of<double>(cloud, "gps_time").at(0), 123456789.123456789);
  std::uint16_t k = 0;
  for (const char* name : {"red", "green", "blue", "nir"}) {
    EXPECT_EQ(values_of<std::uint16_t>(cloud, name).at(0), ++k) << name;
  }
}

TEST(Las, ReadsTheOldBitFields) {
  LasParts parts{.format = 1, .points = 1};
  std::string point(28, '\0');
  point[14] = static_cast<char>(0xd1);  // first of two, both flags
  point[15] = static_cast<char>(0xbf);  // class 31, synthetic, withheld
  point[16] = static_cast<char>(-90);
  const PointCloud cloud = parsed(las_file(parts, point));
  const auto byte = [&](const char* name) { return values_of<std::uint8_t>(cloud, name).at(0); };
  EXPECT_EQ(byte("return_number"), 1);
  EXPECT_EQ(byte("number_of_returns"), 2);
  EXPECT_EQ(byte("scan_direction_flag"), 1);
  EXPECT_EQ(byte("edge_of_flight_line"), 1);
  EXPECT_EQ(byte("classification"), 31);
  EXPECT_EQ(byte("synthetic"), 1);
  EXPECT_EQ(byte("key_point"), 0);
  EXPECT_EQ(byte("withheld"), 1);
  EXPECT_EQ(values_of<std::int8_t>(cloud, "scan_angle_rank").at(0), -90);
}

/// A file with extra bytes of every type.
LasParts parts_with_extras() {
  std::string descriptors;
  std::size_t bytes = 0;
  const std::size_t sizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  for (std::uint8_t type = 1; type <= 10; ++type) {
    descriptors += las_descriptor("type_" + std::to_string(type), type);
    bytes += sizes[type - 1];
  }
  descriptors += las_descriptor("scaled", 6, 24, 0.001, 17);
  descriptors += las_descriptor("wide", 8, 8, 0.001);  // which doubles would not give back
  descriptors += las_descriptor("pair", 15);
  descriptors += las_descriptor("raw", 0, 3);
  LasParts parts{.minor = 4, .format = 6};
  parts.records = las_record("LASF_Spec", 4, descriptors) + las_record("a", 1, "b");
  parts.record_count = 2;
  parts.extra_bytes = bytes + 4 + 8 + 8 + 3 + 2;  // two that nothing describes
  return parts;
}

TEST(Las, KeepsExtraBytesOfEveryType) {
  const TempDir dir;
  const std::string file = las_file(parts_with_extras());
  const PointCloud cloud = parsed(file);
  for (std::size_t type = 0; type < 10; ++type) {
    constexpr ScalarType expected[] = {ScalarType::UInt8,  ScalarType::Int8,   ScalarType::UInt16,
                                       ScalarType::Int16,  ScalarType::UInt32, ScalarType::Int32,
                                       ScalarType::UInt64, ScalarType::Int64,  ScalarType::Float32,
                                       ScalarType::Float64};
    const Attribute* const a = find_attribute(cloud, "type_" + std::to_string(type + 1));
    ASSERT_NE(a, nullptr);
    EXPECT_EQ(a->type(), expected[type]);
  }
  EXPECT_EQ(values_of<double>(cloud, "scaled").size(), 5U);
  EXPECT_EQ(values_of<std::int64_t>(cloud, "wide").size(), 5U);
  EXPECT_EQ(values_of<std::uint32_t>(cloud, "pair").size(), 10U);
  EXPECT_EQ(values_of<std::uint8_t>(cloud, "raw").size(), 15U);
  EXPECT_EQ(values_of<std::uint8_t>(cloud, "extra_bytes").size(), 10U);
  EXPECT_EQ(without_box(written_as(dir, cloud, "a.las")), file);
}

TEST(Las, AddsFieldsBehindThoseOfTheInput) {
  const TempDir dir;
  PointCloud cloud = parsed(las_file(parts_with_extras()));
  const PointCloud before = cloud;
  cloud.normals.assign(5, {0, 0.6, 0.8});
  cloud.attributes.push_back({"deburr_label", std::vector<std::uint8_t>{0, 1, 2, 3, 0}, {}});
  std::vector<std::string> warnings;
  const PointCloud again = parsed(written_as(dir, cloud, "a.las", &warnings));
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_TRUE(same_values(again.normals, cloud.normals));
  EXPECT_TRUE(same_values(again.points, cloud.points));
  EXPECT_THAT(values_of<std::uint8_t>(again, "deburr_label"), ElementsAre(0, 1, 2, 3, 0));
  for (const Attribute& a : before.attributes) {
    const Attribute* const b = find_attribute(again, a.name);
    ASSERT_NE(b, nullptr) << a.name;
    EXPECT_EQ(b->offsets, a.offsets);
    expect_same(std::vector<Attribute>{a}, std::vector<Attribute>{*b});
  }
  EXPECT_EQ(without_box(written_as(dir, again, "b.las")), without_box(get(dir / "a.las")));
}

TEST(Las, KeepsThePlacesOfPointsThatDoNotMove) {
  const TempDir dir;
  LasParts parts{.points = 1000};
  for (const double scale : {0.01, 0.001, 1e-7, 0.25, 1.0 / 3}) {
    for (const double offset : {0.0, 500000.0, -4500000.125, 0.1}) {
      parts.scale = scale;
      parts.offset = offset;
      const PointCloud before = parsed(las_file(parts));
      PointCloud cloud = before;
      for (std::size_t i = 0; i < cloud.size(); i += 3) cloud.points[i].z += 0.3 * scale;
      cloud.layout.resolution = 0.01 * scale;
      (void)write_cloud(dir / "a.las", cloud);
      const PointCloud after = read_cloud(dir / "a.las");
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        ASSERT_TRUE(i % 3 == 0 || same_bits(after.points[i], before.points[i])) << i;
        ASSERT_NEAR(after.points[i].z, cloud.points[i].z, 0.006 * scale + 1e-15 * std::abs(offset));
      }
    }
  }
}

TEST(Las, RefinesItsGridOnlyAsFarAsItIsAsked) {
  const TempDir dir;
  PointCloud cloud = parsed(las_file({}));
  const auto scale_of = [&](double resolution) {
    cloud.layout.resolution = resolution;
    const std::string file = written_as(dir, cloud, "a.las");
    double scale = 0;
    std::memcpy(&scale, file.data() + 131, 8);
    return scale;
  };
  EXPECT_EQ(scale_of(0), 0.01);
  EXPECT_EQ(scale_of(0.01), 0.01);
  EXPECT_EQ(scale_of(0.009), 0.005);
  EXPECT_EQ(scale_of(0.0003), 0.01 / 64);
  EXPECT_LT(scale_of(1e-30), 1e-6);  // as far as 32 bits go
  EXPECT_THAT(write_cloud(dir / "a.las", cloud),
              ElementsAre(HasSubstr("LAS rounds coordinates, here to multiples of")));
}

TEST(Las, ChoosesAGridForCloudsFromElsewhere) {
  const TempDir dir;
  for (const double unit : {1e-6, 1.0, 1e6}) {
    for (const double offset : {0.0, 123456.0, -5e6}) {
      PointCloud cloud;
      for (int i = 0; i < 100; ++i) {
        const double a = 0.37 * i;
        cloud.points.push_back(
            {unit * (offset + std::cos(a)), unit * std::sin(a), unit * 0.01 * i});
      }
      (void)write_cloud(dir / "a.las", cloud);
      const PointCloud again = read_cloud(dir / "a.las");
      for (std::size_t i = 0; i < cloud.size(); ++i) {
        EXPECT_LT(norm(again.points[i] - cloud.points[i]), 1e-8 * unit) << unit << " " << offset;
      }
    }
  }
}

TEST(Las, ChoosesTheFormatByTheFields) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{1, 2, 3}, {4, 5, 6}};
  const auto format_of = [&] { return static_cast<int>(written_as(dir, cloud, "a.las")[104]); };
  const auto add = [&](const char* name, Values values) {
    cloud.attributes.push_back({name, std::move(values), {}});
  };
  EXPECT_EQ(format_of(), 0);
  add("gps_time", std::vector<double>{0.1, 1e9});
  EXPECT_EQ(format_of(), 1);
  for (const char* name : {"red", "green", "blue"}) add(name, std::vector<std::uint8_t>{1, 255});
  EXPECT_EQ(format_of(), 3);
  add("classification", std::vector<std::int64_t>{2, 31});
  EXPECT_EQ(format_of(), 3);
  cloud.attributes.back().values = std::vector<std::int64_t>{2, 64};
  EXPECT_EQ(format_of(), 7);
  const PointCloud again = read_cloud(dir / "a.las");
  EXPECT_THAT(values_of<std::uint8_t>(again, "classification"), ElementsAre(2, 64));
  EXPECT_THAT(values_of<std::uint16_t>(again, "red"), ElementsAre(1, 255));
  EXPECT_THAT(values_of<std::uint8_t>(again, "return_number"), ElementsAre(1, 1));
  add("nir", std::vector<std::uint16_t>{1, 2});
  EXPECT_EQ(format_of(), 8);
}

TEST(Las, HoldsValuesThatItsOwnFieldsCannot) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{1, 2, 3}, {4, 5, 6}};
  cloud.attributes = {{"intensity", std::vector<float>{0.5F, 1e6F}, {}},
                      {"text", std::vector<std::string>{"a", "b"}, {}},
                      {std::string(40, 'n'), std::vector<std::int64_t>{-1, 1}, {}}};
  cloud.layout.comments = {"by hand", ""};
  std::vector<std::string> warnings;
  const PointCloud again = parsed(written_as(dir, cloud, "a.las", &warnings));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("LAS cannot hold the text 'text'"),
                                    HasSubstr("it became 'nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn'")));
  EXPECT_THAT(values_of<float>(again, "intensity"), ElementsAre(0.5F, 1e6F));
  EXPECT_THAT(values_of<std::int64_t>(again, std::string(32, 'n')), ElementsAre(-1, 1));
  EXPECT_THAT(again.layout.comments, ElementsAre("by hand", ""));
}

TEST(Las, RefusesCoordinatesThatAreNotFinite) {
  const TempDir dir;
  PointCloud cloud;
  cloud.points = {{1, 2, 3}, {4, std::numeric_limits<double>::quiet_NaN(), 6}};
  EXPECT_THROW((void)write_cloud(dir / "a.las", cloud), DataError);
  EXPECT_EQ(dir.count(), 0);
}

TEST(Las, RefusesBlocksThatAreNoneOfLas) {
  const TempDir dir;
  PointCloud cloud = parsed(las_file({}));
  for (HeaderBlock& block : cloud.layout.blocks) {
    const std::string whole = block.data;
    block.data.resize(20);
    EXPECT_THROW((void)write_cloud(dir / "a.las", cloud), std::invalid_argument) << block.name;
    block.data = whole;
  }
  EXPECT_EQ(dir.count(), 0);
  cloud.layout.blocks[0].data[104] = 11;  // no point format
  EXPECT_THROW((void)write_cloud(dir / "a.las", cloud), std::invalid_argument);
  cloud.layout.blocks.clear();
  EXPECT_EQ(parsed(written_as(dir, cloud, "a.las")).size(), cloud.size());
}

TEST(Las, NamesTheByteOfWhatIsWrong) {
  const std::string good = las_file({});
  const auto broken = [&](std::size_t at, auto value) {
    std::string file = good;
    put_at(file, at, value);
    return error_of(file);
  };
  EXPECT_EQ(error_of(good), "");
  EXPECT_EQ(error_of(good.substr(0, 100)), "byte 100: the file ends in the header");
  EXPECT_EQ(error_of(good.substr(0, good.size() - 1)),
            "byte " + std::to_string(good.size() - 1) + ": the file ends in point 5 of 5");
  EXPECT_THAT(broken(24, std::uint8_t{2}), HasSubstr("byte 24: unknown version 2.2"));
  EXPECT_THAT(broken(94, std::uint16_t{10}), HasSubstr("byte 94: the header has 10 bytes"));
  EXPECT_THAT(broken(100, std::uint32_t{0xffffffff}), HasSubstr("byte"));
  EXPECT_THAT(broken(96, std::uint32_t{0xffffffff}), HasSubstr("the file ends in what stands"));
  EXPECT_THAT(broken(96, std::uint32_t{230}), HasSubstr("inside of the records"));
  EXPECT_THAT(broken(104, std::uint8_t{11}), HasSubstr("byte 104: unknown point format 11"));
  EXPECT_THAT(broken(104, std::uint8_t{0x83}), HasSubstr("compressed (LAZ)"));
  EXPECT_THAT(broken(105, std::uint16_t{0}), HasSubstr("byte 105: points of 0 bytes"));
  EXPECT_THAT(broken(107, std::uint32_t{0xffffffff}), HasSubstr("point 6 of 4294967295"));
  std::string many = las_file({.minor = 4, .format = 6});
  put_at(many, 247, std::uint64_t{1} << 40);
  EXPECT_THAT(error_of(many), HasSubstr("the file ends in point 6 of 1099511627776"));
  EXPECT_THAT(broken(131, 0.0), HasSubstr("byte 131: scale 0"));
  EXPECT_THAT(broken(163, std::numeric_limits<double>::infinity()), HasSubstr("byte 139: scale"));
}

}  // namespace
}  // namespace deburr

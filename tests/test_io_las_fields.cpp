// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/las_fields.hpp"
#include "support/cloud_files.hpp"
#include "support/las_files.hpp"
#include "support/memory_file.hpp"
#include "support/say_the_same.hpp"

// A value that the field of its name cannot hold in LAS, most of which have a few bits, is kept
// elsewhere under that name.

namespace deburr {
namespace {

std::vector<std::string> all_names() {
  std::set<std::string> names;
  for (unsigned format = 0; format <= las_last_format; ++format) {
    for (const LasField& field : las_fields(format)) names.emplace(field.name);
  }
  return {names.begin(), names.end()};
}

/// All that bits and bytes hold, and the next.
const std::vector<double> values{-129, -128, -1,   0,  1,   2,   3,     4,     7,     8,      15,
                                 16,   17,   31,   32, 127, 128, 255,   256,   32767, 32768,  0.5,
                                 -0.0, 1e9,  -3e4, 5,  63,  64,  65535, 65536, 4e9,   1 << 20};

class LasFieldOf : public testing::TestWithParam<std::string> {};

void expect_kept(const PointCloud& cloud, const std::string& what) {
  std::vector<std::string> warnings;
  const PointCloud again = parsed(written_in_memory(cloud, "las", &warnings), "las");
  for (const Attribute& a : cloud.attributes) {
    const Attribute* const found = find_attribute(again, a.name);
    ASSERT_TRUE(found != nullptr) << what;
    EXPECT_TRUE(say_the_same(a, *found)) << what;
  }
  EXPECT_FALSE(are_named(warnings, "'")) << what;
}

TEST_P(LasFieldOf, KeepsValuesBeyondItsBits) {
  for (const double value : values) {
    PointCloud cloud;
    cloud.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}};
    cloud.attributes = {{GetParam(), std::vector<double>{0, value, 1}, {}}};
    const std::string what = testing::PrintToString(value);
    expect_kept(cloud, what);
    if (value != std::trunc(value) || std::signbit(value)) continue;
    const auto integer = static_cast<std::uint32_t>(value);
    cloud.attributes = {{GetParam(), std::vector<std::uint32_t>{integer, integer, 1}, {}}};
    expect_kept(cloud, what + " as integer");
  }
}

TEST_P(LasFieldOf, KeepsThemInEveryFormatOfInput) {
  for (unsigned format = 0; format <= las_last_format; ++format) {
    const unsigned minor = format >= las_first_modern_format ? 4 : 3;
    for (const double value : values) {
      PointCloud cloud = parsed(las_file({.minor = minor, .format = format}));
      std::erase_if(cloud.attributes, [](const Attribute& a) { return a.name == GetParam(); });
      std::vector<double> numbers(cloud.size(), 1);
      numbers.front() = value;
      cloud.attributes.push_back({GetParam(), numbers, {}});
      expect_kept(cloud, testing::PrintToString(value) + " in " + std::to_string(format));
    }
  }
}

// 2^53 + 1 is the first integer that is no double.
TEST_P(LasFieldOf, KeepsIntegersThatNoDoubleHolds) {
  for (const std::int64_t value : {std::int64_t{1} << 53, (std::int64_t{1} << 53) + 1}) {
    PointCloud cloud;
    cloud.points = {{0, 0, 0}, {1, 0, 0}};
    cloud.attributes = {{GetParam(), std::vector<std::int64_t>{value, -value}, {}}};
    std::vector<std::string> warnings;
    const PointCloud again = parsed(written_in_memory(cloud, "las", &warnings), "las");
    const Attribute* const found = find_attribute(again, GetParam());
    ASSERT_TRUE(found != nullptr);
    EXPECT_EQ(std::get<std::vector<std::int64_t>>(found->values)[0], value);
  }
}

// An extra field takes the name of one of the format that is 0 everywhere. It does not move there.
TEST(LasExtra, GoesBackToWhereItCameFrom) {
  constexpr std::size_t bytes = 2;
  constexpr std::size_t intensity_at = 12;
  for (const bool is_zero : {true, false}) {
    for (const std::size_t count : {1U, 2U}) {
      std::string descriptors;
      for (std::size_t k = 0; k < count; ++k) descriptors += las_descriptor("intensity", 3);
      const LasParts parts{.records = las_record("LASF_Spec", 4, descriptors),
                           .extra_bytes = count * bytes};
      std::string points = las_points(parts);
      const std::size_t size = las_sizes[0] + parts.extra_bytes;
      for (std::size_t i = 0; is_zero && i < parts.points; ++i) {
        put_at(points, i * size + intensity_at, std::uint16_t{0});
      }
      const std::string file = las_file(parts, points);
      const PointCloud cloud = parsed(file);
      EXPECT_EQ(find_attribute(cloud, count == 2 ? "intensity__" : "intensity_") == nullptr,
                is_zero);
      std::vector<std::string> warnings;
      EXPECT_EQ(without_box(written_in_memory(cloud, "las", &warnings)), file) << is_zero << count;
      EXPECT_THAT(warnings, testing::IsEmpty());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Names, LasFieldOf, testing::ValuesIn(all_names()),
                         [](const auto& given) { return given.param; });

}  // namespace
}  // namespace deburr

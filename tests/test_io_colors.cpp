// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "support/cloud_files.hpp"
#include "support/memory_file.hpp"
#include "support/say_the_same.hpp"

// Colours of 8 and 16 bits and real numbers, with and without alpha, in formats that hold
// fractions.

namespace deburr {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

PointCloud colored(const Values& colors, const Values& alpha = {}) {
  PointCloud cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}};
  for (const char* name : {"red", "green", "blue"}) cloud.attributes.push_back({name, colors, {}});
  if (alpha.index() != 0) cloud.attributes.push_back({"alpha", alpha, {}});
  return cloud;
}

class Fractions : public testing::TestWithParam<std::string> {
 protected:
  /// Which attributes are not the same any more.
  static std::vector<std::string> changed(const PointCloud& cloud) {
    std::vector<std::string> names;
    const PointCloud again = parsed(written_in_memory(cloud, GetParam(), &warnings), GetParam());
    for (const Attribute& a : cloud.attributes) {
      const Attribute* const found = find_attribute(again, a.name);
      if (found == nullptr || !say_the_same(a, *found)) names.push_back(a.name);
    }
    return names;
  }
  inline static std::vector<std::string> warnings;
};

TEST_P(Fractions, KeepAllColoursOf16Bits) {
  std::vector<std::uint16_t> all(65536);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint16_t>(i);
  PointCloud cloud = colored(all);
  cloud.points.resize(all.size());
  EXPECT_THAT(changed(cloud), IsEmpty());
  EXPECT_THAT(warnings, IsEmpty());
  const std::string file = written_in_memory(cloud, GetParam());
  EXPECT_TRUE(written_in_memory(parsed(file, GetParam()), GetParam()) == file);
}

TEST_P(Fractions, KeepAlphaOfTheSameKind) {
  const std::vector<std::uint16_t> words{300, 1, 65535};
  const std::vector<std::uint16_t> dark{200, 0, 255};
  const std::vector<std::uint8_t> bytes{200, 0, 255};
  EXPECT_THAT(changed(colored(words, words)), IsEmpty());
  EXPECT_THAT(changed(colored(words, dark)), IsEmpty());
  EXPECT_THAT(changed(colored(dark, words)), IsEmpty());
  EXPECT_THAT(changed(colored(dark, bytes)), IsEmpty());
  EXPECT_THAT(changed(colored(bytes, bytes)), IsEmpty());
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_THAT(changed(colored(words, bytes)), ElementsAre("alpha"));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("holds 'alpha' in as many bits as the colours")));
  EXPECT_THAT(changed(colored(bytes, words)), ElementsAre("alpha"));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("cannot hold the integers 'alpha'")));
}

INSTANTIATE_TEST_SUITE_P(Formats, Fractions, testing::Values("off", "obj"),
                         [](const auto& given) { return given.param; });

// Real numbers stay such, also where they are steps of 16 bits, with as many digits as those have.
TEST(Off, TellsRealNumbersFromColoursOf16Bits) {
  for (const std::vector<double>& reals : {std::vector<double>{0, 1, 1},
                                           {0.2, 0.4, 1},
                                           {0.000015259022, 0.030518043793, 0.030518043793}}) {
    const std::string file = written_in_memory(colored(reals), "off");
    EXPECT_EQ(values_of<double>(parsed(file), "red"), reals) << file;
  }
  const std::vector<std::uint16_t> ends{0, 65535, 65535};
  EXPECT_EQ(values_of<std::uint16_t>(parsed(written_in_memory(colored(ends), "off")), "red"), ends);
  const PointCloud others = parsed("COFF\n1 0 0\n0 0 0 1.000000 0.200000 0.400000 1.000000\n");
  EXPECT_THAT(values_of<double>(others, "green"), ElementsAre(0.2));
}

}  // namespace
}  // namespace deburr

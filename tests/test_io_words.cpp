// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "support/cloud_files.hpp"
#include "support/memory_file.hpp"
#include "support/say_the_same.hpp"

// Words with any byte in them, as comments, names and values: what is written can be read, and what
// changed on the way is named.

namespace deburr {
namespace {

const std::vector<std::string> formats{"ply", "las", "pcd", "obj", "off", "csv", "xyz", "pts"};

PointCloud three_points() {
  PointCloud cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}};
  return cloud;
}

/// Every byte: alone, in front, behind, and in the middle.
std::vector<std::string> words_of_all_bytes() {
  std::vector<std::string> words{"", " ", "  a  b  ", "#c", "# c", "//c", "vtk", ".PCD", "x y z"};
  for (int byte = 0; byte < 256; ++byte) {
    const std::string c(1, static_cast<char>(byte));
    for (const std::string& word : {c, c + "a", "a" + c, "a" + c + "b"}) words.push_back(word);
  }
  return words;
}

class AnyByte : public testing::TestWithParam<std::string> {};

TEST_P(AnyByte, InAComment) {
  for (const std::string& word : words_of_all_bytes()) {
    PointCloud cloud = three_points();
    cloud.layout.comments = {"before", word, "behind"};
    std::vector<std::string> warnings;
    const std::string file = written_in_memory(cloud, GetParam(), &warnings);
    const PointCloud again = parsed(file);
    EXPECT_EQ(again.size(), 3U) << testing::PrintToString(word);
    const bool is_same = again.layout.comments == cloud.layout.comments;
    EXPECT_NE(is_same, are_named(warnings, "comment")) << testing::PrintToString(word);
  }
}

TEST_P(AnyByte, InAName) {
  for (const std::string& word : words_of_all_bytes()) {
    PointCloud cloud = three_points();
    cloud.attributes = {{"a" + word, std::vector<std::uint16_t>{1, 2, 70}, {}}};
    std::vector<std::string> warnings;
    const std::string file = written_in_memory(cloud, GetParam(), &warnings);
    const PointCloud again = parsed(file);
    EXPECT_EQ(again.size(), 3U) << testing::PrintToString(word);
    const bool is_same = find_attribute(again, "a" + word) != nullptr;
    EXPECT_NE(is_same, are_named(warnings, "'a" + word + "'")) << testing::PrintToString(word);
  }
}

TEST_P(AnyByte, InAValue) {
  for (const std::string& word : words_of_all_bytes()) {
    PointCloud cloud = three_points();
    cloud.attributes = {{"a", std::vector<std::string>{"b", word, "c"}, {}}};
    std::vector<std::string> warnings;
    const std::string file = written_in_memory(cloud, GetParam(), &warnings);
    const PointCloud again = parsed(file);
    EXPECT_EQ(again.size(), 3U) << testing::PrintToString(word);
    const Attribute* const a = find_attribute(again, "a");
    const bool is_same = a != nullptr && say_the_same(cloud.attributes[0], *a);
    EXPECT_NE(is_same, are_named(warnings, "'a'")) << testing::PrintToString(word);
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, AnyByte, testing::ValuesIn(formats),
                         [](const auto& given) { return given.param; });

}  // namespace
}  // namespace deburr

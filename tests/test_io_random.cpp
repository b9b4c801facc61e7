// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <optional>

#include "deburr/error.hpp"
#include "support/cloud_files.hpp"
#include "support/memory_file.hpp"
#include "support/random_cloud.hpp"
#include "support/same_cloud.hpp"
#include "support/say_the_same.hpp"

// Laws that hold for every cloud, tried on random ones: what is not named in a warning is there,
// and what was read is written back to the byte.

namespace deburr {
namespace {

bool is_number_text(const Attribute& a) {
  const auto* const words = std::get_if<std::vector<std::string>>(&a.values);
  return words != nullptr &&
         std::ranges::all_of(*words, [](const std::string& w) { return w == "1"; });
}

/// Where a point may be after it was written.
double tolerance(const std::string& format, const PointCloud& before) {
  if (format == "stl") return 0.5;  // a float at 5.4e6
  return format == "las" && before.layout.encoding != Encoding::Las ? 1e-2 : 0;
}

void expect_kept(const PointCloud& before, const PointCloud& after,
                 const std::vector<std::string>& warnings, const std::string& format) {
  ASSERT_EQ(after.size(), before.size());
  const double most = tolerance(format, before);
  for (std::size_t i = 0; i < before.size(); ++i) {
    ASSERT_LE(norm(after.points[i] - before.points[i]), most) << i;
  }
  if (!before.normals.empty()) {
    EXPECT_NE(same_values(after.normals, before.normals), are_named(warnings, "normals"));
  }
  for (const Attribute& a : before.attributes) {
    const Attribute* const found = find_attribute(after, a.name);
    const bool is_there = found != nullptr && (say_the_same(a, *found) || is_number_text(a));
    EXPECT_NE(is_there, are_named(warnings, "'" + a.name + "'")) << a.name;
  }
  for (const Element& e : before.layout.elements) {
    const auto found = std::ranges::find(after.layout.elements, e.name, &Element::name);
    const bool is_there = found != after.layout.elements.end() && found->size == e.size;
    EXPECT_NE(is_there, are_named(warnings, "hold the element '" + e.name + "'")) << e.name;
  }
  const bool same_comments = after.layout.comments == before.layout.comments;
  EXPECT_NE(same_comments, are_named(warnings, "comments"));
}

class RandomIo : public testing::TestWithParam<unsigned> {};

/// Writes and reads again; none where the format has no place for the cloud.
std::optional<PointCloud> through(const PointCloud& cloud, const std::string& format) {
  SCOPED_TRACE("to " + format);
  if (format == "stl" && cloud.layout.elements.empty()) {
    EXPECT_THROW((void)written_in_memory(cloud, format), DataError);
    return std::nullopt;
  }
  std::vector<std::string> warnings;
  const std::string file = written_in_memory(cloud, format, &warnings);
  PointCloud again = parsed(file, format);
  expect_kept(cloud, again, warnings, format);
  EXPECT_TRUE(written_in_memory(again, format, &warnings) == file);
  EXPECT_THAT(warnings, testing::IsEmpty());
  return again;
}

TEST_P(RandomIo, KeepsOrNamesEverythingFromEveryFormatToEveryOther) {
  const PointCloud cloud = RandomClouds(GetParam()).next();
  const std::vector<std::string> formats{"ply", "las", "pcd", "stl", "obj", "off", "csv", "pts"};
  for (const std::string& first : formats) {
    SCOPED_TRACE("from " + first);
    const std::optional<PointCloud> once = through(cloud, first);
    if (!once) continue;
    for (const std::string& second : formats) (void)through(*once, second);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomIo, testing::Range(1U, 25U));

}  // namespace
}  // namespace deburr

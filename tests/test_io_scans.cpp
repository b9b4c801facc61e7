// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "support/cloud_files.hpp"
#include "support/same_cloud.hpp"
#include "support/say_the_same.hpp"

// Real scans, where they are at hand: through every format and back, value by value.

namespace deburr {
namespace {

namespace fs = std::filesystem;

class Scans : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!fs::exists(path)) GTEST_SKIP() << "NOT TESTED: the scan " << path << " is not there";
  }
  const fs::path path = fs::path(DEBURR_SOURCE_DIR) / "../shared/data/scans" / GetParam();
};

TEST_P(Scans, AreWrittenBackByteByByte) {
  const TempDir dir;
  const std::string name = path.filename();
  std::vector<std::string> warnings;
  const PointCloud scan = read_cloud(path);
  const std::string once = written_as(dir, scan, name, &warnings);
  EXPECT_THAT(warnings, testing::IsEmpty());
  const bool is_text = path.extension() == ".csv" || path.extension() == ".pcd";
  // Programs pad and round numbers in text in ways of their own.
  EXPECT_TRUE(is_text || once == get(path));
  expect_same(parsed(once), scan);
}

/// Compares value by value; what is not there has to be named.
void expect_kept(const PointCloud& before, const PointCloud& after,
                 const std::vector<std::string>& warnings) {
  ASSERT_EQ(after.size(), before.size());
  const bool has_new_grid =
      after.layout.encoding == Encoding::Las && before.layout.encoding != Encoding::Las;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (has_new_grid) {
      ASSERT_LT(norm(after.points[i] - before.points[i]), 1e-6);
    } else {
      ASSERT_TRUE(same_bits(after.points[i], before.points[i])) << i;
    }
  }
  EXPECT_TRUE(same_values(after.normals, before.normals) || are_named(warnings, "normals"));
  for (const Attribute& a : before.attributes) {
    const Attribute* const found = find_attribute(after, a.name);
    ASSERT_NE(found != nullptr, are_named(warnings, "'" + a.name + "'")) << a.name;
    ASSERT_TRUE(found == nullptr || say_the_same(a, *found)) << a.name;
  }
}

TEST_P(Scans, SurviveEveryFormatAndTheWayBack) {
  const TempDir dir;
  const PointCloud scan = read_cloud(path);
  const std::string own = "back" + path.extension().string();
  for (const std::string name : {"ply", "las", "pcd", "obj", "off", "csv", "txt", "pts"}) {
    SCOPED_TRACE(name);
    const std::vector<std::string> warnings = write_cloud(dir / ("a." + name), scan);
    const PointCloud there = read_cloud(dir / ("a." + name));
    expect_kept(scan, there, warnings);
    const std::vector<std::string> more = write_cloud(dir / own, there);
    expect_kept(there, read_cloud(dir / own), more);
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Scans,
                         testing::Values("autzen.las", "street_car.pcd", "lidar_car401.csv",
                                         "sfm_sceaux.ply", "rabbit.ply", "kinect_objects.ply"),
                         [](const auto& instance) {
                           return instance.param.substr(0, instance.param.find('.'));
                         });

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "support/cloud_files.hpp"
#include "support/same_cloud.hpp"

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

double as_double(const Attribute& attribute, std::size_t i) {
  return std::visit(
      [&]<typename T>(const std::vector<T>& values) {
        if constexpr (std::is_same_v<T, std::string>) {
          return 0.0;
        } else {
          return static_cast<double>(values[i]);
        }
      },
      attribute.values);
}

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

TEST_P(Scans, SurviveEveryFormat) {
  const TempDir dir;
  const PointCloud scan = read_cloud(path);
  for (const std::string name : {"ply", "las", "pcd", "obj", "off", "csv"}) {
    SCOPED_TRACE(name);
    const std::vector<std::string> warnings = write_cloud(dir / ("a." + name), scan);
    const PointCloud again = read_cloud(dir / ("a." + name));
    ASSERT_EQ(again.size(), scan.size());
    const bool has_grid = name == "las" && scan.layout.encoding != Encoding::Las;
    for (std::size_t i = 0; i < scan.size(); ++i) {
      if (has_grid) {
        ASSERT_LT(norm(again.points[i] - scan.points[i]), 1e-6);
      } else {
        ASSERT_TRUE(same_bits(again.points[i], scan.points[i])) << i;
      }
    }
    for (const Attribute& before : scan.attributes) {
      const Attribute* const after = find_attribute(again, before.name);
      const bool is_named = std::ranges::any_of(warnings, [&](const std::string& w) {
        return w.find("'" + before.name + "'") != std::string::npos;
      });
      ASSERT_NE(after != nullptr, is_named) << before.name;
      for (std::size_t i = 0; after != nullptr && i < scan.size(); ++i) {
        ASSERT_EQ(as_double(*after, i), as_double(before, i)) << before.name << " " << i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Files, Scans,
                         testing::Values("autzen.las", "street_car.pcd", "lidar_car401.csv",
                                         "sfm_sceaux.ply", "rabbit.ply"),
                         [](const auto& instance) {
                           return instance.param.substr(0, instance.param.find('.'));
                         });

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "view/fields.hpp"

// Fields of a cloud that a page shows, whatever they are called.

namespace deburr::view {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ViewFields, KnowHowBrightColoursAre) {
  PointCloud cloud;
  cloud.points.assign(2, {});
  const auto with = [&](const Values& values) {
    cloud.attributes = {{"r", values, {}}, {"g", values, {}}, {"b", values, {}}};
    return ColourField::of(cloud).value()[0][0];
  };
  EXPECT_EQ(with(std::vector<std::uint8_t>{51, 3}), 51);
  EXPECT_EQ(with(std::vector<std::uint16_t>{51, 255}), 51);
  EXPECT_EQ(with(std::vector<std::uint16_t>{51 * 257, 65535}), 51);
  EXPECT_EQ(with(std::vector<float>{0.2F, 1}), 51);
  EXPECT_EQ(with(std::vector<double>{51, 200}), 51);
  EXPECT_EQ(with(std::vector<double>{nan, 200}), 0);
  cloud.attributes.pop_back();
  EXPECT_FALSE(ColourField::of(cloud).has_value());
}

TEST(ViewFields, TheClassOfLasMarksOutliersOnlyBesideLabels) {
  PointCloud cloud;
  cloud.points.assign(2, {});
  cloud.attributes = {{"classification", std::vector<std::uint8_t>{7, 2}, {}}};
  EXPECT_TRUE(outliers_of(cloud).empty());
  cloud.attributes.push_back({"deburr_label", std::vector<std::uint8_t>{3, 0}, {}});
  EXPECT_EQ(outliers_of(cloud), (std::vector<std::uint8_t>{1, 0}));
}

}  // namespace
}  // namespace deburr::view

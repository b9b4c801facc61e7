// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cctype>

#include "deburr/synth.hpp"
#include "view/colours.hpp"
#include "view/font.hpp"
#include "view/legend.hpp"
#include "view/still.hpp"

// What stands below a still picture: it can be read, and it does not change the picture.

namespace deburr::view {
namespace {

constexpr Rgb white{255, 255, 255};
constexpr Rgb black{0, 0, 0};

Picture blank(int width, int height) {
  return {width, height,
          std::vector<std::uint8_t>(
              3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255)};
}

Rgb pixel(const Picture& picture, int x, int y) {
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
           static_cast<std::size_t>(x));
  return {picture.rgb.at(at), picture.rgb.at(at + 1), picture.rgb.at(at + 2)};
}

/// The dots of a letter, a row per line.
std::string dots(char letter) {
  Picture picture = blank(letter_width, letter_height);
  write(picture, 0, 0, std::string(1, letter), 1, black);
  std::string text;
  for (int y = 0; y < letter_height; ++y) {
    for (int x = 0; x < letter_width; ++x) text += pixel(picture, x, y) == black ? '#' : '.';
    text += '\n';
  }
  return text;
}

TEST(ViewFont, LettersAreTheirOwn) {
  const std::string known = "abcdefghijklmnopqrstuvwxyz0123456789+-.,";
  const std::string box = dots('?');
  for (std::size_t i = 0; i < known.size(); ++i) {
    EXPECT_NE(dots(known[i]), box) << known[i];
    EXPECT_NE(dots(known[i]), dots(' ')) << known[i];
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(dots(known[i]), dots(known[j])) << known[i];
  }
  EXPECT_EQ(dots('e'), "......\n......\n.###..\n#...#.\n#####.\n#.....\n.####.\n......\n......\n");
  EXPECT_EQ(dots('\n'), box);
}

TEST(ViewFont, TextIsAsWideAsItSays) {
  Picture picture = blank(40, 20);
  write(picture, 2, 1, "me", 2, black);
  int rightmost = 0;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 40; ++x) {
      if (pixel(picture, x, y) == black) rightmost = std::max(rightmost, x);
    }
  }
  EXPECT_EQ(rightmost + 1, 2 + text_width("me", 2));
  // What lies outside of the picture is not drawn, and nothing else is.
  write(picture, -100, -100, "me", 3, black);
  write(picture, 38, 15, "me", 3, black);
  EXPECT_EQ(text_width("", 3), 0);
}

Legend bar() { return {.title = "abc", .map = diverging, .low = -0.5, .high = 0.5}; }

TEST(ViewLegend, HasTheColoursOfItsMap) {
  Picture picture = blank(400, 300);
  const LegendSize size = size_of(bar(), 400, 300);
  ASSERT_GT(size.height, 0);
  append(bar(), size, white, picture);
  EXPECT_EQ(picture.height, 300 + size.height);
  EXPECT_EQ(picture.rgb.size(), 3U * 400U * static_cast<std::size_t>(picture.height));
  int first = -1;
  int last = -1;
  bool grey = false;
  for (int y = 300; y < picture.height; ++y) {
    for (int x = 0; x < 400; ++x) {
      const Rgb seen = pixel(picture, x, y);
      if (seen == diverging.front() && first < 0) first = x;
      if (seen == diverging.back()) last = x;
      grey = grey || (seen == Rgb{221, 221, 221} && x > 190 && x < 210);
    }
  }
  EXPECT_TRUE(grey);
  EXPECT_GE(first, 0);
  EXPECT_LT(first, 200);
  EXPECT_NEAR(first, 400 - 1 - last, 1);  // in the middle
}

TEST(ViewLegend, LeavesSmallPicturesAlone) {
  EXPECT_EQ(size_of(bar(), 60, 45).height, 0);
  EXPECT_EQ(size_of(bar(), 1200, 45).height, 0);
  EXPECT_GE(size_of(bar(), 1200, 900).scale, 2);
  EXPECT_LE(size_of(bar(), 2000, 500).height, 125);
  Picture picture = blank(60, 45);
  append(bar(), size_of(bar(), 60, 45), white, picture);
  EXPECT_EQ(picture.height, 45);
}

/// A cloud with labels, or with a displacement, that says 1 everywhere.
PointCloud marked(const char* field) {
  PointCloud cloud = synthesize_part({.points = 2000, .noise = 0}).cloud;
  cloud.attributes.push_back({field, std::vector<std::uint8_t>(2000, 1), {}});
  return cloud;
}

bool has_colour(const Picture& picture, const Rgb& colour, int from_row) {
  for (int y = from_row; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (pixel(picture, x, y) == colour) return true;
    }
  }
  return false;
}

TEST(ViewStill, SaysWhatLabelsMean) {
  const PointCloud cloud = marked("deburr_label");
  const Request request{.before = {.name = "a", .cloud = &cloud}};
  StillOptions options{.colour = StillColour::Labels, .raster = {.width = 400, .height = 300}};
  const StillPicture with = draw_still(request, options);
  EXPECT_TRUE(with.legend);
  EXPECT_EQ(with.picture.height, 300);
  for (const Rgb& colour : label_colours) EXPECT_TRUE(has_colour(with.picture, colour, 270));
  EXPECT_TRUE(has_colour(with.picture, outlier_colour, 270));
  options.legend = false;
  const StillPicture without = draw_still(request, options);
  EXPECT_FALSE(without.legend);
  EXPECT_EQ(without.picture.height, 300);
  EXPECT_FALSE(has_colour(without.picture, outlier_colour, 0));
}

TEST(ViewStill, SaysWhatTheDisplacementIs) {
  const PointCloud cloud = marked("deburr_displacement");
  const Request request{.before = {.name = "a", .cloud = &cloud}};
  StillOptions options{.colour = StillColour::Displacement,
                       .raster = {.width = 400, .height = 300}};
  const StillPicture still = draw_still(request, options);
  EXPECT_TRUE(still.legend);
  EXPECT_TRUE(has_colour(still.picture, sequential.front(), 250));
  EXPECT_TRUE(has_colour(still.picture, sequential.back(), 250));
  options.colour = StillColour::Normals;
  EXPECT_FALSE(draw_still(request, options).legend);
  options.colour = StillColour::Displacement;
  options.raster = {.width = 60, .height = 40};
  EXPECT_FALSE(draw_still(request, options).legend);
}

}  // namespace
}  // namespace deburr::view

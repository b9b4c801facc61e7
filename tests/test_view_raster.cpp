// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "deburr/error.hpp"
#include "deburr/synth.hpp"
#include "view/colours.hpp"
#include "view/png.hpp"
#include "view/raster.hpp"
#include "view/still.hpp"

// Still pictures: pixels are where the points are.

namespace deburr::view {
namespace {

Rgb pixel(const Picture& picture, int x, int y) {
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
           static_cast<std::size_t>(x));
  return {picture.rgb.at(at), picture.rgb.at(at + 1), picture.rgb.at(at + 2)};
}

/// The unit cube, with a face per colour: +x red, +y green, +z blue, the others black.
struct Cube {
  std::vector<Vec3> points;
  std::vector<Vec3> normals;
  std::vector<Rgb> colours;

  Cube() {
    constexpr int n = 40;
    for (int axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        for (int i = 0; i <= n; ++i) {
          for (int j = 0; j <= n; ++j)
            add(axis, side, static_cast<double>(i) / n, static_cast<double>(j) / n);
        }
      }
    }
  }

  void add(int axis, int side, double u, double v) {
    const double s = side;
    const double out = 2 * s - 1;
    points.push_back(axis == 0 ? Vec3{s, u, v} : axis == 1 ? Vec3{u, s, v} : Vec3{u, v, s});
    normals.push_back(axis == 0 ? Vec3{out, 0, 0} : axis == 1 ? Vec3{0, out, 0} : Vec3{0, 0, out});
    Rgb colour{};
    if (side == 1) colour[static_cast<std::size_t>(axis)] = 200;
    colours.push_back(colour);
  }

  [[nodiscard]] Splats splats() const {
    return {.points = points, .normals = normals, .colours = colours, .radius = 0.03};
  }
};

constexpr RasterOptions unlit{.width = 106, .height = 106, .samples = 2, .light = 0};
constexpr Rgb white{255, 255, 255};

TEST(ViewRaster, ShowsTheFaceThatTheViewerLooksAt) {
  const Cube cube;
  const auto middle = [&](View view) {
    return pixel(draw(cube.splats(), Camera::fit(view, cube.points, 106, 106), unlit), 53, 53);
  };
  EXPECT_EQ(middle(View::Right), (Rgb{200, 0, 0}));
  EXPECT_EQ(middle(View::Back), (Rgb{0, 200, 0}));
  EXPECT_EQ(middle(View::Top), (Rgb{0, 0, 200}));
  EXPECT_EQ(middle(View::Left), (Rgb{0, 0, 0}));
  EXPECT_EQ(middle(View::Front), (Rgb{0, 0, 0}));
  EXPECT_EQ(middle(View::Bottom), (Rgb{0, 0, 0}));
}

// A cube of side 1 and a margin of 6 % make 100 of 106 pixels.
TEST(ViewRaster, FillsThePictureButForItsMargin) {
  const Cube cube;
  const Picture picture = draw(cube.splats(), Camera::fit(View::Top, cube.points, 106, 106), unlit);
  ASSERT_EQ(picture.rgb.size(), 3U * 106 * 106);
  for (const auto& [x, y] : {std::pair{5, 53}, {100, 53}, {53, 5}, {53, 100}, {30, 70}}) {
    EXPECT_EQ(pixel(picture, x, y), (Rgb{0, 0, 200})) << x << " " << y;
  }
  for (const auto& [x, y] : {std::pair{0, 0}, {105, 105}}) {
    EXPECT_EQ(pixel(picture, x, y), white) << x << " " << y;
  }
}

TEST(ViewRaster, RightIsRightAndUpIsUp) {
  const std::vector<Vec3> points{{0, 0, 0}, {10, 0, 0}, {10, 0, 10}};
  const std::vector<Rgb> colours{{10, 0, 0}, {20, 0, 0}, {30, 0, 0}};
  const Camera camera = Camera::fit(View::Front, points, 106, 106);
  const Picture picture = draw({points, {}, colours, 0.5}, camera, unlit);
  EXPECT_EQ(pixel(picture, 3, 102)[0], 10);
  EXPECT_EQ(pixel(picture, 102, 102)[0], 20);
  EXPECT_EQ(pixel(picture, 102, 3)[0], 30);
  EXPECT_EQ(pixel(picture, 3, 3), white);
}

TEST(ViewRaster, DiscsLieInTheirSurface) {
  // Seen from the side, the disc of a point is a line as thin as the least cosine allows.
  const std::vector<Vec3> points{{0, 0, 0}};
  const std::vector<Vec3> normals{{0, 0, 1}};
  const std::vector<Rgb> colours{{0, 0, 0}};
  Camera camera = Camera::fit(View::Front, points, 101, 101);
  camera.scale = 50;
  const RasterOptions options{.width = 101, .height = 101, .samples = 1, .light = 0};
  const Picture picture = draw({points, normals, colours, 0.8}, camera, options);
  EXPECT_EQ(pixel(picture, 50 + 38, 50), (Rgb{0, 0, 0}));
  EXPECT_EQ(pixel(picture, 50, 50 + 8), (Rgb{0, 0, 0}));
  EXPECT_EQ(pixel(picture, 50, 50 + 38), white);
}

TEST(ViewRaster, LightFallsOnBothSides) {
  const std::vector<Vec3> points{{0, 0, 0}};
  const std::vector<Rgb> colours{{200, 200, 200}};
  const Camera camera = Camera::fit(View::Top, points, 9, 9);
  const auto with = [&](const Vec3& normal, double light) {
    return pixel(draw({points, std::vector{normal}, colours, 100}, camera,
                      {.width = 9, .height = 9, .samples = 1, .light = light}),
                 4, 4)[0];
  };
  EXPECT_EQ(with({0, 0, 1}, 0.7), with({0, 0, -3}, 0.7));
  EXPECT_LT(with({1, 0, 0.3}, 0.7), with({0, 0, 1}, 0.7));
  EXPECT_EQ(with({1, 0, 0.3}, 0), 200);
  EXPECT_EQ(with({0, 0, 0}, 0.7), 200);
}

TEST(ViewRaster, IsTheSameEveryTimeAndLeavesOutWhatIsNotFinite) {
  Cube cube;
  for (std::size_t i = 0; i < 500; ++i) {
    cube.points[i * 7].x = std::numeric_limits<double>::quiet_NaN();
  }
  const Camera camera = Camera::fit(View::Iso, cube.points, 64, 48);
  EXPECT_TRUE(std::isfinite(camera.scale) && is_finite(camera.centre));
  const RasterOptions options{.width = 64, .height = 48};
  EXPECT_EQ(png_bytes(draw(cube.splats(), camera, options)),
            png_bytes(draw(cube.splats(), camera, options)));
  const std::vector<Vec3> none{cube.points[0]};
  const std::vector<Rgb> colour{{0, 0, 0}};
  EXPECT_EQ(pixel(draw({none, {}, colour, 1}, Camera::fit(View::Iso, none, 8, 8),
                       {.width = 8, .height = 8}),
                  4, 4),
            white);
}

// Far outside, no number is one of a sample, and the way to the picture would never end.
TEST(ViewRaster, PassesOverWhatLiesFarOutside) {
  Cube cube;
  const RasterOptions options{.width = 64, .height = 48};
  const Camera camera = Camera::fit(View::Iso, cube.points, 64, 48);
  cube.points[0].x = std::numeric_limits<double>::quiet_NaN();
  const std::string without = png_bytes(draw(cube.splats(), camera, options));
  for (const double far : {1e7, 1e12, 1e30, 1e300}) {
    for (const double right : {-far, far}) {
      for (const double up : {-far, far}) {
        cube.points[0] = camera.centre + right * camera.right + up * camera.up;
        EXPECT_TRUE(png_bytes(draw(cube.splats(), camera, options)) == without) << right << up;
      }
    }
  }
}

TEST(ViewRaster, EndsWhenToldTo) {
  const Cube cube;
  const Camera camera = Camera::fit(View::Iso, cube.points, 64, 48);
  int looks = 0;
  const Execution execution{.cancelled = [&] { return ++looks == 3; }};
  EXPECT_THROW((void)draw(cube.splats(), camera, {.width = 64, .height = 48}, execution),
               Cancelled);
  EXPECT_EQ(looks, 3);
}

TEST(ViewRaster, RefusesOptionsOutOfRange) {
  const Cube cube;
  const Camera camera;
  EXPECT_THROW((void)draw(cube.splats(), camera, {.width = 0}), std::invalid_argument);
  EXPECT_THROW((void)draw(cube.splats(), camera, {.height = 20'000}), std::invalid_argument);
  EXPECT_THROW((void)draw(cube.splats(), camera, {.samples = 9}), std::invalid_argument);
  EXPECT_THROW((void)draw({cube.points, {}, {}, 1}, camera), std::invalid_argument);
  EXPECT_THROW((void)draw({cube.points, {}, cube.colours, 0}, camera), std::invalid_argument);
}

TEST(ViewPng, IsReadBackAsItWas) {
  const Cube cube;
  const Picture picture =
      draw(cube.splats(), Camera::fit(View::Iso, cube.points, 50, 40), {.width = 50, .height = 40});
  const std::string bytes = png_bytes(picture);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  image.format = PNG_FORMAT_RGB;
  EXPECT_EQ(image.width, 50U);
  EXPECT_EQ(image.height, 40U);
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr), 0);
  EXPECT_EQ(rgb, picture.rgb);
  EXPECT_THROW((void)png_bytes({}), std::invalid_argument);
}

TEST(ViewColours, GoFromEndToEnd) {
  EXPECT_EQ(sample(diverging, 0), diverging.front());
  EXPECT_EQ(sample(diverging, 0.5), diverging[4]);
  EXPECT_EQ(sample(diverging, 7), diverging.back());
  EXPECT_EQ(sample(sequential, -1), sequential.front());
  EXPECT_EQ(sample(sequential, std::nan("")), unknown_colour);
}

StillOptions small_still() {
  StillOptions options;
  options.raster.width = 60;
  options.raster.height = 40;
  return options;
}

TEST(ViewStill, ColoursShowWhatTheyAreAskedFor) {
  PointCloud cloud = synthesize_part({.points = 3000, .noise = 0}).cloud;
  const Request request{.before = {.name = "a.ply", .cloud = &cloud}};
  StillOptions options = small_still();
  EXPECT_EQ(draw_still(request, options).points, 3000U);
  for (const StillColour colour :
       {StillColour::Displacement, StillColour::Labels, StillColour::OfFile}) {
    options.colour = colour;
    EXPECT_THROW((void)draw_still(request, options), DataError);
  }
  cloud.attributes.push_back({"deburr_label", std::vector<std::uint8_t>(3000, 1), {}});
  cloud.attributes.push_back({"deburr_displacement", std::vector<float>(3000, 2.5F), {}});
  options.colour = StillColour::Labels;
  options.raster.light = 0;
  const Rgb middle = pixel(draw_still(request, options).picture, 30, 25);
  EXPECT_GT(middle[0], 2 * middle[1] - 10);  // the hue of an edge, in some light
  EXPECT_LT(middle[2], 20);
  options.colour = StillColour::Displacement;
  const StillPicture still = draw_still(request, options);
  EXPECT_EQ(still.range, 2.5);
  EXPECT_FALSE(still.is_signed);
  const PointCloud empty;
  EXPECT_THROW((void)draw_still({.before = {.name = "e", .cloud = &empty}}), DataError);
}

// As in a scan with a stray 0 0 0 far from all else: discs are as large as without it.
TEST(ViewStill, ASinglePointFarOffMakesNoDifference) {
  PointCloud cloud = synthesize_part({.points = 3000, .noise = 0}).cloud;
  const Request request{.before = {.name = "a.ply", .cloud = &cloud}};
  StillOptions options = small_still();
  const auto covered = [&] {
    const std::vector<std::uint8_t> rgb = draw_still(request, options).picture.rgb;
    return std::ranges::count_if(rgb, [](std::uint8_t value) { return value < 250; });
  };
  const auto usual = static_cast<double>(covered());
  EXPECT_LT(usual, 0.8 * 3 * 60 * 40);
  cloud.points[7] = {1e7, -1e7, 1e6};
  EXPECT_NEAR(static_cast<double>(covered()), usual, 0.05 * usual);
}

TEST(ViewStill, AnyAxisCanBeUp) {
  PointCloud cloud = synthesize_part({.points = 2000, .noise = 0}).cloud;
  cloud.normals.clear();
  for (const View view : {View::Iso, View::Front, View::Top}) {
    const StillOptions options{.view = view, .raster = {.width = 60, .height = 45}};
    const Picture upright = draw_still({.before = {.name = "a", .cloud = &cloud}}, options).picture;
    for (const Up up : {Up::Y, Up::X, Up::MinusZ, Up::MinusY, Up::MinusX}) {
      const UpFrame frame = frame_of(up);
      PointCloud turned;
      for (const Vec3& p : cloud.points) {
        turned.points.push_back(p.x * frame.right + p.y * frame.forward + p.z * frame.up);
      }
      StillOptions same = options;
      same.up = up;
      const Picture seen = draw_still({.before = {.name = "b", .cloud = &turned}}, same).picture;
      // But for rounding.
      std::size_t other = 0;
      for (std::size_t i = 0; i < seen.rgb.size(); ++i) {
        if (std::abs(seen.rgb[i] - upright.rgb[i]) > 40) ++other;
      }
      EXPECT_LT(other, seen.rgb.size() / 50) << to_string(up);
    }
  }
}

TEST(ViewStill, MovementAlongNormalsHasASign) {
  const PointCloud before = synthesize_part({.points = 500, .noise = 0}).cloud;
  PointCloud after = before;
  after.normals.assign(500, {0, 0, 1});
  for (Vec3& p : after.points) p.z += 0.5;
  const StillPicture still =
      draw_still({.before = {.name = "a", .cloud = &before},
                  .after = ShownCloud{.name = "b", .cloud = &after}},
                 {.colour = StillColour::Displacement, .raster = {.width = 30, .height = 30}});
  EXPECT_TRUE(still.is_signed);
  EXPECT_NEAR(still.range, 0.5, 1e-9);
}

}  // namespace
}  // namespace deburr::view

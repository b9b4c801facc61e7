// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "deburr/synth.hpp"
#include "view/encode.hpp"
#include "view/fields.hpp"
#include "view/page.hpp"
#include "view/scene.hpp"

// The points of a page: what is read back from it is what the clouds hold.

namespace deburr::view {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr std::size_t plenty = 100'000'000;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Reads an array of a page again, as the page does.
class Decoded {
 public:
  explicit Decoded(const Scene& scene)
      : scene_(json::parse(scene.description)), data_(scene.data) {}

  [[nodiscard]] const json& about() const { return scene_; }
  [[nodiscard]] std::size_t shown(std::size_t cloud) const {
    return scene_["clouds"][cloud]["shown"];
  }
  [[nodiscard]] bool has(std::size_t cloud, const char* name) const {
    return scene_["clouds"][cloud]["arrays"].contains(name);
  }
  [[nodiscard]] double value(std::size_t cloud, const char* name, std::size_t point,
                             std::size_t component = 0) const {
    const json& array = scene_["clouds"][cloud]["arrays"][name];
    const std::size_t width = array["type"] == "u24" ? 3 : array["type"] == "u16" ? 2 : 1;
    const std::size_t components = array["components"];
    std::size_t at = array["offset"];
    at += (point * components + component) * width;
    std::uint32_t q = 0;
    for (std::size_t k = 0; k < width; ++k) {
      q |= static_cast<std::uint32_t>(static_cast<unsigned char>(data_.at(at + k))) << (8 * k);
    }
    if (!array.contains("step")) return q;
    return array["low"][component].get<double>() + array["step"][component].get<double>() * q;
  }
  [[nodiscard]] Vec3 point(std::size_t cloud, std::size_t i) const {
    return {value(cloud, "position", i, 0), value(cloud, "position", i, 1),
            value(cloud, "position", i, 2)};
  }
  [[nodiscard]] double step(std::size_t cloud) const {
    double largest = 0;
    for (const json& s : scene_["clouds"][cloud]["arrays"]["position"]["step"]) {
      largest = std::max(largest, s.get<double>());
    }
    return largest;
  }

 private:
  json scene_;
  std::string data_;
};

/// A scan moved to coordinates of a survey, with every field that a page knows.
PointCloud survey(std::size_t points) {
  PointCloud cloud = synthesize_part({.points = points}).cloud;
  for (Vec3& p : cloud.points) p += Vec3{500'000, 4'500'000, 120};
  std::vector<std::uint16_t> red(points);
  std::vector<float> intensity(points);
  std::vector<std::uint8_t> label(points);
  std::vector<std::uint8_t> outlier(points);
  for (std::size_t i = 0; i < points; ++i) {
    red[i] = static_cast<std::uint16_t>(i * 65535 / points);
    intensity[i] = static_cast<float>(i) - 10;
    label[i] = static_cast<std::uint8_t>(i % 4);
    outlier[i] = i % 7 == 0 ? 1 : 0;
  }
  cloud.attributes.push_back({"red", red, {}});
  cloud.attributes.push_back({"green", red, {}});
  cloud.attributes.push_back({"blue", red, {}});
  cloud.attributes.push_back({"intensity", intensity, {}});
  cloud.attributes.push_back({"deburr_label", label, {}});
  cloud.attributes.push_back({"deburr_outlier", outlier, {}});
  return cloud;
}

/// The index of the point at a place.
std::size_t index_of(const PointCloud& cloud, const Vec3& place, double tolerance) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (norm(cloud.points[i] - place) <= tolerance) return i;
  }
  ADD_FAILURE() << "no such point";
  return 0;
}

TEST(ViewScene, HoldsWhatTheCloudHolds) {
  const PointCloud cloud = survey(400);
  const Decoded page(make_scene({.before = {.name = "a", .cloud = &cloud}}, plenty));
  ASSERT_EQ(page.shown(0), 400U);
  EXPECT_LT(page.step(0), 1e-5);
  for (std::size_t k = 0; k < 400; k += 37) {
    const std::size_t i = index_of(cloud, page.point(0, k), 2 * page.step(0));
    EXPECT_NEAR(page.value(0, "colour", k), static_cast<double>(i * 65535 / 400) / 257, 0.51);
    EXPECT_NEAR(page.value(0, "intensity", k), static_cast<double>(i) - 10, 0.01);
    EXPECT_EQ(page.value(0, "flags", k), static_cast<double>(i % 4 + (i % 7 == 0 ? 8 : 0)));
  }
  EXPECT_EQ(page.about()["clouds"][0]["estimatedNormals"], true);
  EXPECT_FALSE(page.has(0, "displacement"));
}

TEST(ViewScene, PairsPointsAndMeasuresTheirMovement) {
  const PointCloud before = survey(300);
  PointCloud after = before;
  after.normals.assign(300, {0, 0, 2});
  for (std::size_t i = 0; i < 300; ++i) {
    after.points[i] += Vec3{0.1, 0, i % 2 == 0 ? 0.5 : -0.25};
  }
  const Scene scene = make_scene({.before = {.name = "a", .cloud = &before},
                                  .after = ShownCloud{.name = "b", .cloud = &after}},
                                 plenty);
  EXPECT_TRUE(scene.paired);
  EXPECT_TRUE(scene.warnings.empty());
  const Decoded page(scene);
  ASSERT_EQ(page.shown(0), page.shown(1));
  for (std::size_t k = 0; k < page.shown(1); ++k) {
    const Vec3 moved = page.point(1, k) - page.point(0, k);
    EXPECT_NEAR(moved.x, 0.1, 1e-4);
    EXPECT_NEAR(page.value(1, "displacement", k), moved.z, 1e-4);
  }
  const json& summary = page.about()["displacement"];
  EXPECT_EQ(summary["signed"], true);
  EXPECT_NEAR(summary["max"].get<double>(), 0.5, 1e-8);
  EXPECT_NEAR(summary["mean"].get<double>(), 0.375, 1e-8);
  std::size_t counted = summary["histogram"]["below"].get<std::size_t>() +
                        summary["histogram"]["above"].get<std::size_t>();
  for (const json& n : summary["histogram"]["counts"]) counted += n.get<std::size_t>();
  EXPECT_EQ(counted, 300U);
}

TEST(ViewScene, APointThatDidNotMoveHasNotMoved) {
  const PointCloud before = survey(300);
  PointCloud after = before;
  after.points[7] += Vec3{3, 2, 1};
  const Decoded page(make_scene({.before = {.name = "a", .cloud = &before},
                                 .after = ShownCloud{.name = "b", .cloud = &after}},
                                plenty));
  std::size_t moved = 0;
  for (std::size_t k = 0; k < 300; ++k) {
    if (page.point(0, k) != page.point(1, k)) ++moved;
  }
  EXPECT_EQ(moved, 1U);
}

TEST(ViewScene, WholeNumbersStayWhole) {
  PointCloud cloud = survey(100);
  const Decoded page(make_scene({.before = {.name = "a", .cloud = &cloud}}, plenty));
  const std::size_t i = index_of(cloud, page.point(0, 11), 2 * page.step(0));
  EXPECT_EQ(page.value(0, "intensity", 11), static_cast<double>(i) - 10);
}

TEST(ViewScene, WithoutNormalsTheMovementHasNoSign) {
  const PointCloud before = survey(100);
  PointCloud after = before;
  for (Vec3& p : after.points) p += Vec3{0.3, 0, 0.4};
  const Decoded page(make_scene({.before = {.name = "a", .cloud = &before},
                                 .after = ShownCloud{.name = "b", .cloud = &after}},
                                plenty));
  EXPECT_EQ(page.about()["displacement"]["signed"], false);
  EXPECT_NEAR(page.value(1, "displacement", 5), 0.5, 1e-4);
}

TEST(ViewScene, CloudsOfOneSizeNeedNotBeTheSamePoints) {
  const PointCloud before = survey(500);
  PointCloud after = before;
  std::ranges::reverse(after.points);
  std::ranges::rotate(after.points, after.points.begin() + 137);
  const Scene scene = make_scene({.before = {.name = "a", .cloud = &before},
                                  .after = ShownCloud{.name = "b", .cloud = &after}},
                                 plenty);
  EXPECT_FALSE(scene.paired);
  ASSERT_EQ(scene.warnings.size(), 1U);
  EXPECT_THAT(scene.warnings[0], HasSubstr("not the same points"));
}

TEST(ViewScene, ShowsWhatWasLeftOutAfterThePairs) {
  const PointCloud before = survey(200);
  PointCloud after;
  std::vector<std::uint32_t> origin;
  std::vector<Feature> labels;
  for (std::uint32_t i = 0; i < 200; ++i) {
    if (i % 10 == 3) continue;
    after.points.push_back(before.points[i]);
    origin.push_back(i);
    labels.push_back(Feature::Edge);
  }
  PointCloud plain = before;
  plain.attributes.clear();
  const Decoded page(
      make_scene({.before = {.name = "a", .cloud = &plain},
                  .after = ShownCloud{.name = "b", .cloud = &after, .labels = labels},
                  .origin = origin},
                 plenty));
  ASSERT_EQ(page.shown(1), 180U);
  ASSERT_EQ(page.shown(0), 200U);
  for (std::size_t k = 0; k < 200; ++k) {
    const bool pair = k < 180;
    EXPECT_EQ(page.value(0, "flags", k), pair ? 1 : 7 + 8);
    if (pair) {
      EXPECT_LT(norm(page.point(0, k) - page.point(1, k)), 2 * page.step(0));
    }
  }
}

TEST(ViewScene, WhatWasRemovedIsAnOutlierWhateverElseIsKnown) {
  const PointCloud plain = synthesize_part({.points = 60}).cloud;
  PointCloud labelled = plain;
  labelled.attributes.push_back({"deburr_label", std::vector<std::uint8_t>(60, 2), {}});
  PointCloud after;
  std::vector<std::uint32_t> origin;
  for (std::uint32_t i = 0; i < 60; ++i) {
    if (i % 10 == 3) continue;
    after.points.push_back(plain.points[i]);
    origin.push_back(i);
  }
  // Labels of the first cloud stay; without any, those in both clouds have an unknown one.
  for (const PointCloud* before : {&plain, static_cast<const PointCloud*>(&labelled)}) {
    const Decoded page(make_scene({.before = {.name = "a", .cloud = before},
                                   .after = ShownCloud{.name = "b", .cloud = &after},
                                   .origin = origin},
                                  plenty));
    EXPECT_EQ(page.about()["removed"], 6);
    const int label = before == &plain ? 7 : 2;
    for (std::size_t k = 0; k < 60; ++k) {
      EXPECT_EQ(page.value(0, "flags", k), k < 54 ? label : label + 8);
    }
  }
  // Where nothing was removed nothing is said.
  const Decoded whole(make_scene(
      {.before = {.name = "a", .cloud = &plain}, .after = ShownCloud{.name = "b", .cloud = &plain}},
      plenty));
  EXPECT_EQ(whole.about()["removed"], 0);
  EXPECT_FALSE(whole.has(0, "flags"));
}

/// What is left of a cloud without every tenth point, moved, with the field that says how far.
PointCloud without_some(const PointCloud& before) {
  PointCloud after;
  std::vector<float> moved;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (i % 10 == 3) continue;
    const double by = 0.01 * static_cast<double>(i % 17);
    after.points.push_back(before.points[i] + Vec3{0, 0, by});
    after.normals.push_back({0, 0, 1});
    moved.push_back(static_cast<float>(by));
  }
  after.attributes.push_back({"deburr_displacement", moved, {}});
  return after;
}

TEST(ViewScene, FindsWhatWasRemovedByHowFarTheOthersMoved) {
  PointCloud before = survey(200);
  before.points[50].x = nan;
  PointCloud after = without_some(before);
  const auto scene = [&] {
    return make_scene({.before = {.name = "a", .cloud = &before},
                       .after = ShownCloud{.name = "b", .cloud = &after}},
                      plenty);
  };
  const Scene paired = scene();
  EXPECT_TRUE(paired.paired);
  EXPECT_TRUE(paired.warnings.empty());
  const Decoded page(paired);
  EXPECT_EQ(page.about()["removed"], 20);
  EXPECT_EQ(page.about()["displacement"]["signed"], true);
  ASSERT_EQ(page.shown(1), 179U);
  for (std::size_t k = 0; k < 179; ++k) {
    const Vec3 moved = page.point(1, k) - page.point(0, k);
    EXPECT_NEAR(moved.x, 0, 1e-4);
    EXPECT_NEAR(moved.z, page.value(1, "displacement", k), 1e-4);
  }
  for (std::size_t k = 179; k < page.shown(0); ++k) EXPECT_GE(page.value(0, "flags", k), 8);

  // One point that does not fit, another order, or nothing that says how far: no pairs.
  const PointCloud good = after;
  after.points[90].x += 3;
  EXPECT_FALSE(scene().paired);
  after = good;
  std::ranges::reverse(after.points);
  EXPECT_FALSE(scene().paired);
  after = good;
  after.attributes.clear();
  EXPECT_FALSE(scene().paired);
}

TEST(ViewScene, TellsWhichAxisIsUp) {
  const PointCloud cloud = survey(20);
  const Request request{.before = {.name = "a", .cloud = &cloud}};
  EXPECT_EQ(Decoded(make_scene(request, plenty)).about()["up"], "z");
  EXPECT_EQ(Decoded(make_scene(request, plenty, {.up = Up::MinusY})).about()["up"], "-y");
}

TEST(ViewScene, LeavesOutWhatIsNotFinite) {
  PointCloud before = survey(100);
  PointCloud after = before;
  before.points[3].x = nan;
  after.points[4].y = std::numeric_limits<double>::infinity();
  const Decoded page(make_scene({.before = {.name = "a", .cloud = &before},
                                 .after = ShownCloud{.name = "b", .cloud = &after}},
                                plenty));
  EXPECT_EQ(page.shown(0), 98U);
  EXPECT_EQ(page.shown(1), 98U);
  EXPECT_EQ(page.about()["clouds"][0]["nonFinite"], 1);

  PointCloud nothing;
  nothing.points.assign(5, {nan, 0, 0});
  EXPECT_EQ(make_scene({.before = {.name = "a", .cloud = &nothing}}, plenty).shown[0], 0U);
  const PointCloud empty;
  EXPECT_EQ(make_scene({.before = {.name = "a", .cloud = &empty}}, plenty).shown[0], 0U);
}

TEST(ViewScene, StaysWithinItsRoom) {
  const PointCloud cloud = survey(3000);
  PointCloud after = cloud;
  for (const std::size_t room : {0U, 100U, 30'000U, 60'000U}) {
    const Scene scene = make_scene({.before = {.name = "a", .cloud = &cloud},
                                    .after = ShownCloud{.name = "b", .cloud = &after}},
                                   room);
    EXPECT_LE(base64_size(scene.data.size()), room + 4);
    if (room < 30'000) continue;
    EXPECT_GT(base64_size(scene.data.size()), room * 9 / 10);
  }
}

TEST(ViewScene, TellsTheTruthWhereItIsGiven) {
  const PointCloud cloud = survey(50);
  std::vector<double> distance(50);
  for (std::size_t i = 0; i < 50; ++i) distance[i] = static_cast<double>(i);
  const Decoded page(
      make_scene({.before = {.name = "a", .cloud = &cloud, .truth_distance = distance}}, plenty));
  const std::size_t i = index_of(cloud, page.point(0, 20), 2 * page.step(0));
  EXPECT_NEAR(page.value(0, "truth", 20), static_cast<double>(i), 1e-3);
  EXPECT_EQ(page.about()["truth"][0]["max"], 49);
}

TEST(ViewScene, TheSameCloudGivesTheSameBytes) {
  const PointCloud cloud = survey(2000);
  const Request request{.before = {.name = "a", .cloud = &cloud}};
  const Scene one = make_scene(request, 30'000, {}, {.threads = 1});
  const Scene three = make_scene(request, 30'000, {}, {.threads = 3});
  EXPECT_EQ(one.data, three.data);
  EXPECT_EQ(one.description, three.description);
}

TEST(ViewScene, RefusesWhatDoesNotFitTogether) {
  const PointCloud cloud = survey(20);
  const std::vector<double> three(3);
  EXPECT_THROW(
      (void)make_scene({.before = {.name = "a", .cloud = &cloud, .truth_distance = three}}, plenty),
      std::invalid_argument);
  const std::vector<std::uint32_t> outside(20, 20);
  EXPECT_THROW((void)make_scene({.before = {.name = "a", .cloud = &cloud},
                                 .after = ShownCloud{.name = "b", .cloud = &cloud},
                                 .origin = outside},
                                plenty),
               std::invalid_argument);
}

}  // namespace
}  // namespace deburr::view

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <numeric>
#include <string>
#include <vector>

#include "deburr/synth.hpp"
#include "keep_points.hpp"
#include "support/same_cloud.hpp"

namespace deburr {
namespace {

using testing::Each;
using testing::ElementsAre;

/// Five points, of which the first, the fourth and the last are outliers.
DenoiseResult marked() {
  DenoiseResult result;
  PointCloud& cloud = result.cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}};
  cloud.normals = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {0, 3, 0}, {0, 4, 0}};
  cloud.attributes.push_back({"number", std::vector<std::int32_t>{0, 1, 2, 3, 4}, {}});
  cloud.attributes.push_back({"word", std::vector<std::string>{"a", "b", "c", "d", "e"}, {}});
  // Lists of 1, 0, 3, 2 and 1 entries.
  cloud.attributes.push_back({.name = "list",
                              .values = std::vector<float>{0, 20, 21, 22, 30, 31, 40},
                              .offsets = {0, 1, 1, 4, 6, 7}});
  cloud.layout.comments = {"kept"};
  cloud.layout.elements = {
      {"face",
       4,
       {{"vertex_indices",
         std::vector<std::int32_t>{0, 1, 2, 2, 1, 1, 2, 4, 2, 1},
         {0, 3, 6, 8, 10}},
        {"color", std::vector<std::uint8_t>{10, 11, 12, 13}, {}}},
       false},
      {"edge",
       3,
       {{"vertex1", std::vector<std::uint16_t>{1, 2, 2}, {}},
        {"vertex2", std::vector<std::uint16_t>{2, 9, 3}, {}}},
       false},
      {"strip", 1, {{"vertices", std::vector<std::int32_t>{1, 2}, {0, 2}}}, false}};
  result.labels = {Feature::Isolated, Feature::Edge, Feature::Surface, Feature::Isolated,
                   Feature::Isolated};
  result.displacement = {0, 0.1, 0.2, 0, 0};
  result.outliers = {1, 0, 0, 1, 1};
  return result;
}

TEST(KeepPoints, TakesOutliersOutOfEveryArray) {
  DenoiseResult result = marked();
  remove_outliers(result);
  const PointCloud& cloud = result.cloud;
  EXPECT_THAT(cloud.points, ElementsAre(Vec3{1, 0, 0}, Vec3{2, 0, 0}));
  EXPECT_THAT(cloud.normals, ElementsAre(Vec3{0, 1, 0}, Vec3{0, 2, 0}));
  EXPECT_THAT(std::get<std::vector<std::int32_t>>(cloud.attributes[0].values), ElementsAre(1, 2));
  EXPECT_THAT(std::get<std::vector<std::string>>(cloud.attributes[1].values),
              ElementsAre("b", "c"));
  EXPECT_THAT(std::get<std::vector<float>>(cloud.attributes[2].values), ElementsAre(20, 21, 22));
  EXPECT_THAT(cloud.attributes[2].offsets, ElementsAre(0, 0, 3));
  EXPECT_THAT(result.labels, ElementsAre(Feature::Edge, Feature::Surface));
  EXPECT_THAT(result.displacement, ElementsAre(0.1, 0.2));
  EXPECT_THAT(result.outliers, ElementsAre(0, 0));
  EXPECT_THAT(cloud.layout.comments, ElementsAre("kept"));
  // Faces and edges that lose a point go; nobody knows what else refers to which point.
  ASSERT_EQ(cloud.layout.elements.size(), 2U);
  const Element& faces = cloud.layout.elements[0];
  EXPECT_EQ(faces.size, 2U);
  EXPECT_THAT(std::get<std::vector<std::int32_t>>(faces.attributes[0].values),
              ElementsAre(1, 0, 0, 1, 0));
  EXPECT_THAT(faces.attributes[0].offsets, ElementsAre(0, 3, 5));
  EXPECT_THAT(std::get<std::vector<std::uint8_t>>(faces.attributes[1].values), ElementsAre(11, 13));
  const Element& edges = cloud.layout.elements[1];
  EXPECT_EQ(edges.size, 1U);
  EXPECT_THAT(std::get<std::vector<std::uint16_t>>(edges.attributes[0].values), ElementsAre(0));
  EXPECT_THAT(std::get<std::vector<std::uint16_t>>(edges.attributes[1].values), ElementsAre(1));
}

TEST(KeepPoints, KeepsAllOrNone) {
  DenoiseResult all = marked();
  all.outliers.assign(5, 0);
  remove_outliers(all);
  EXPECT_EQ(all.cloud.points, marked().cloud.points);
  EXPECT_EQ(all.cloud.attributes[2].offsets, marked().cloud.attributes[2].offsets);

  DenoiseResult none = marked();
  none.outliers.assign(5, 1);
  remove_outliers(none);
  EXPECT_EQ(none.cloud.size(), 0U);
  EXPECT_TRUE(none.cloud.normals.empty());
  EXPECT_THAT(none.cloud.attributes[2].offsets, ElementsAre(0));
  EXPECT_TRUE(none.displacement.empty());
}

/// A cube with outliers whose points carry their number.
PointCloud numbered_cube() {
  PointCloud cloud =
      synthesize(Shape::Cube,
                 {.points = 1500, .noise = 0.3, .noise_unit = NoiseUnit::Spacing, .outliers = 0.05})
          .cloud;
  std::vector<std::int32_t> number(cloud.size());
  for (std::size_t i = 0; i < number.size(); ++i) number[i] = static_cast<std::int32_t>(i);
  cloud.attributes = {{"number", number, {}}};
  cloud.layout.elements.push_back({"strip", 0, {}, false});
  return cloud;
}

TEST(KeepPoints, IsWhatDenoiseDoesWhereItIsToRemove) {
  const PointCloud cloud = numbered_cube();
  const DenoiseResult labelled = denoise(cloud);
  const DenoiseResult removed = denoise(cloud, {.automatic = {.outliers = OutlierAction::Remove}});
  ASSERT_GT(labelled.report.outliers, 30U);
  EXPECT_EQ(removed.report.outliers, labelled.report.outliers);
  EXPECT_EQ(removed.report.points, cloud.size());
  EXPECT_EQ(removed.report.kept, removed.cloud.size());
  EXPECT_EQ(labelled.report.kept, cloud.size());
  EXPECT_EQ(std::accumulate(removed.report.labels.begin(), removed.report.labels.end(), 0U),
            cloud.size());
  ASSERT_EQ(removed.cloud.size(), cloud.size() - labelled.report.outliers);
  ASSERT_EQ(removed.cloud.normals.size(), removed.cloud.size());
  ASSERT_EQ(removed.labels.size(), removed.cloud.size());
  ASSERT_EQ(removed.displacement.size(), removed.cloud.size());
  EXPECT_EQ(removed.outliers, std::vector<std::uint8_t>(removed.cloud.size(), 0));
  EXPECT_TRUE(removed.cloud.layout.elements.empty());
  EXPECT_FALSE(labelled.cloud.layout.elements.empty());
  const auto& number = std::get<std::vector<std::int32_t>>(removed.cloud.attributes[0].values);
  for (std::size_t k = 0; k < number.size(); ++k) {
    const auto i = static_cast<std::size_t>(number[k]);
    ASSERT_EQ(labelled.outliers[i], 0);
    ASSERT_TRUE(same_bits(removed.cloud.points[k], labelled.cloud.points[i]));
    ASSERT_TRUE(same_bits(removed.cloud.normals[k], labelled.cloud.normals[i]));
    ASSERT_EQ(removed.labels[k], labelled.labels[i]);
    ASSERT_EQ(removed.displacement[k], labelled.displacement[i]);
  }
}

TEST(KeepPoints, LooksForNoOutliersWhereAllAreKept) {
  const DenoiseResult kept =
      denoise(numbered_cube(), {.automatic = {.outliers = OutlierAction::Keep}});
  EXPECT_EQ(kept.report.outliers, 0U);
  EXPECT_THAT(kept.outliers, Each(0));
}

// The published method knows none.
TEST(KeepPoints, RemovesNothingByThePublishedMethod) {
  const PointCloud cloud = numbered_cube();
  const DenoiseResult result = denoise(cloud, {.method = Method::Yadav2018,
                                               .automatic = {.outliers = OutlierAction::Remove},
                                               .yadav2018 = {.rounds = 1}});
  EXPECT_EQ(result.cloud.size(), cloud.size());
  EXPECT_EQ(result.report.kept, cloud.size());
  EXPECT_THAT(result.outliers, Each(0));
}

}  // namespace
}  // namespace deburr

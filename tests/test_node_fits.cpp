// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "node_fits.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

constexpr double sigma = 0.3;

/// A flat grid with noise across it, as nodes at distances of 1.
struct Flat {
  std::vector<Vec3> truth = plane_grid(24).points;
  std::vector<Vec3> measured;
  NodeLevels levels;

  Flat()
      : measured(across(truth)),
        levels(nodes_of_points(measured, truth, std::vector<Vec3>(truth.size(), Vec3{0, 0, 1})), 1,
               sigma) {}
  static std::vector<Vec3> across(std::vector<Vec3> points) {
    Random random(1);
    for (Vec3& p : points) p.z += sigma * random.gaussian();
    return points;
  }
};

std::set<std::uint32_t> nodes_of(const std::vector<NodeSheet>& sheets) {
  std::set<std::uint32_t> nodes;
  for (const NodeSheet& s : sheets) nodes.insert(s.node);
  return nodes;
}

TEST(NodeFits, SurveyOneOfSoManyNodes) {
  const Flat flat;
  for (const std::size_t step : {1U, 3U}) {
    const Survey survey = survey_nodes(flat.levels, sigma, step, {}, {});
    EXPECT_TRUE(survey.sheets.further.empty());
    EXPECT_EQ(survey.sheets.even.size(), (flat.truth.size() + step - 1) / step);
    for (const NodeSheet& s : survey.sheets.even) {
      EXPECT_EQ(s.node % step, 0U);
      EXPECT_TRUE(s.sheet.valid);
      EXPECT_EQ(s.sheet.frame.origin, flat.truth[s.node]);
    }
    // Fewer of them at all scales.
    EXPECT_LT(survey.curves.size(), survey.sheets.even.size());
    ASSERT_EQ(survey.places.size(), survey.curves.size());
    ASSERT_EQ(survey.fits.size(), survey.curves.size());
    for (const ScaleCurve& curve : survey.curves) EXPECT_GT(curve.freedom[0], 0);
  }
}

TEST(NodeFits, AreAtAllNodesByEdgesAndAtAnEvenChoiceElsewhere) {
  const Flat flat;
  const FitSteps steps{3, 8, 2};
  const Survey survey = survey_nodes(flat.levels, sigma, steps.survey, {}, {});
  std::vector<std::uint8_t> by_edge(flat.truth.size());
  for (std::size_t i = 0; i < by_edge.size(); ++i) by_edge[i] = flat.truth[i].x > 0 ? 1 : 0;
  const NodeSheets sheets =
      fit_nodes(flat.levels, survey, flat.levels, by_edge, sigma, steps, {}, {});
  std::set<std::uint32_t> even;
  std::set<std::uint32_t> further;
  for (std::uint32_t i = 0; i < by_edge.size(); ++i) {
    if (i % steps.even == 0) {
      even.insert(i);
    } else if (by_edge[i] != 0 && i % steps.edges == 0) {
      further.insert(i);
    }
  }
  EXPECT_EQ(nodes_of(sheets.even), even);
  EXPECT_EQ(nodes_of(sheets.further), further);
  for (const NodeSheet& s : sheets.even) EXPECT_LT(std::abs(s.sheet.middle().z), sigma);
}

TEST(NodeFits, AreFewerWhereNoiseMakesThemOverlap) {
  const FitSteps few = fit_steps(0.2, {});
  const FitSteps many = fit_steps(1, {});
  EXPECT_EQ(few.survey, 1U);
  EXPECT_EQ(few.even, 1U);
  EXPECT_GT(many.survey, few.survey);
  EXPECT_GT(many.even, many.survey);
  EXPECT_LT(many.edges, many.even);
  // Without what stands in for a missing sheet there must be one at every node.
  for (const AutomaticParts& parts :
       {AutomaticParts{.surer_sheet = false}, AutomaticParts{.blend = false}}) {
    const FitSteps all = fit_steps(1, parts);
    EXPECT_EQ(all.survey, 1U);
    EXPECT_EQ(all.even, 1U);
    EXPECT_EQ(all.edges, 1U);
  }
}

TEST(NodeFits, HaveTheSameBitsForAnyThreads) {
  const Flat flat;
  const Survey one = survey_nodes(flat.levels, sigma, 2, {}, {.threads = 1});
  const Survey many = survey_nodes(flat.levels, sigma, 2, {}, {.threads = 5});
  ASSERT_EQ(one.sheets.even.size(), many.sheets.even.size());
  for (std::size_t i = 0; i < one.sheets.even.size(); ++i) {
    EXPECT_EQ(one.sheets.even[i].node, many.sheets.even[i].node);
    EXPECT_EQ(one.sheets.even[i].sheet.height.c, many.sheets.even[i].sheet.height.c);
  }
}

TEST(SheetSet, KeepsTheEvenChoiceFirst) {
  NodeSheets fitted;
  for (std::uint32_t i = 0; i < 40; ++i) {
    Sheet sheet;
    sheet.frame = frame_along({static_cast<double>(i), 0, 0}, {0, 0, 1});
    sheet.valid = true;
    if (i % 4 == 0) fitted.even.push_back({i, sheet});
    if (i % 4 == 1) fitted.further.push_back({i, sheet});
  }
  const SheetSet set(fitted, 40);
  ASSERT_EQ(set.sheets().size(), 20U);
  EXPECT_EQ(set.even().order().size(), 10U);
  EXPECT_EQ(set.all().order().size(), 20U);
  for (std::uint32_t i = 0; i < 40; ++i) {
    if (i % 4 > 1) {
      EXPECT_EQ(set.of(i), SheetSet::none);
    } else {
      ASSERT_LT(set.of(i), 20U);
      EXPECT_EQ(set.sheets()[set.of(i)].frame.origin.x, i);
      EXPECT_EQ(set.of(i) < 10, i % 4 == 0);
    }
  }
  fitted.further.clear();
  const SheetSet even(fitted, 40);
  EXPECT_EQ(even.all().order().size(), 10U);
}

}  // namespace
}  // namespace deburr

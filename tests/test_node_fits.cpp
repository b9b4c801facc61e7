// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
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

using Nodes = std::set<std::uint32_t>;

Nodes even_nodes(const NodeSheets& all) {
  return {all.nodes.begin(), all.nodes.begin() + static_cast<std::ptrdiff_t>(all.even)};
}
Nodes further_nodes(const NodeSheets& all) {
  return {all.nodes.begin() + static_cast<std::ptrdiff_t>(all.even), all.nodes.end()};
}

TEST(NodeFits, SurveyOneOfSoManyNodes) {
  const Flat flat;
  for (const std::size_t step : {1U, 3U}) {
    const Survey survey = survey_nodes(flat.levels, sigma, step, {}, {});
    const NodeSheets& all = survey.sheets;
    ASSERT_EQ(all.sheets.size(), all.nodes.size());
    EXPECT_TRUE(further_nodes(all).empty());
    EXPECT_EQ(even_nodes(all).size(), (flat.truth.size() + step - 1) / step);
    for (std::size_t k = 0; k < all.sheets.size(); ++k) {
      EXPECT_EQ(all.nodes[k] % step, 0U);
      EXPECT_TRUE(all.sheets[k].valid);
      EXPECT_EQ(all.sheets[k].place, flat.truth[all.nodes[k]]);
    }
    // Fewer of them at all scales.
    const ScaleSurvey& scales = survey.scales;
    EXPECT_LT(scales.curves.size(), all.sheets.size());
    ASSERT_EQ(scales.places.size(), scales.curves.size());
    ASSERT_EQ(scales.normals.size(), scales.curves.size());
    for (const ScaleCurve& curve : scales.curves) EXPECT_GT(curve.freedom[0], 0);
    for (const Vec3& n : scales.normals) EXPECT_EQ(n, (Vec3{0, 0, 1}));
    for (std::size_t level = 0; level < node_levels; ++level) {
      EXPECT_EQ(scales.merged[level], flat.levels.merged(level));
    }
  }
}

TEST(NodeFits, AreAtAllNodesByEdgesAndAtAnEvenChoiceElsewhere) {
  const Flat flat;
  const FitSteps steps{3, 8, 2, 100};
  const Survey survey = survey_nodes(flat.levels, sigma, steps.survey, {}, {});
  std::vector<std::uint8_t> by_edge(flat.truth.size());
  for (std::size_t i = 0; i < by_edge.size(); ++i) by_edge[i] = flat.truth[i].x > 0 ? 1 : 0;
  const NodeSheets sheets = fit_nodes(survey.scales, flat.levels, by_edge, sigma, steps, {}, {});
  Nodes even, further;
  for (std::uint32_t i = 0; i < by_edge.size(); ++i) {
    if (i % steps.even == 0) {
      even.insert(i);
    } else if (by_edge[i] != 0 && i % steps.edges == 0) {
      further.insert(i);
    }
  }
  EXPECT_EQ(even_nodes(sheets), even);
  EXPECT_EQ(further_nodes(sheets), further);
  for (std::size_t k = 0; k < sheets.sheets.size(); ++k) {
    EXPECT_LT(std::abs(sheets.sheets[k].middle().z), sigma);
    EXPECT_EQ(sheets.sheets[k].place, flat.truth[sheets.nodes[k]]);
  }
}

TEST(NodeFits, AreFewerWhereNoiseMakesThemOverlap) {
  const FitSteps few = fit_steps(0.2, false, {});
  const FitSteps many = fit_steps(1, true, {});
  EXPECT_EQ(few.even, 1U);
  EXPECT_GT(many.survey, few.survey);
  EXPECT_GT(many.even, many.survey);
  EXPECT_LT(many.edges, many.even);
  // Without what stands in for a missing sheet there must be one at every node.
  for (const AutomaticParts& parts :
       {AutomaticParts{.surer_sheet = false}, AutomaticParts{.blend = false}}) {
    const FitSteps all = fit_steps(1, true, parts);
    EXPECT_EQ(all.survey, 1U);
    EXPECT_EQ(all.even, 1U);
    EXPECT_EQ(all.edges, 1U);
  }
}

TEST(NodeFits, HaveTheSameBitsForAnyThreads) {
  const Flat flat;
  const Survey one = survey_nodes(flat.levels, sigma, 2, {}, {.threads = 1});
  const Survey many = survey_nodes(flat.levels, sigma, 2, {}, {.threads = 5});
  ASSERT_EQ(one.sheets.nodes, many.sheets.nodes);
  for (std::size_t i = 0; i < one.sheets.sheets.size(); ++i) {
    EXPECT_EQ(one.sheets.sheets[i].middle(), many.sheets.sheets[i].middle());
    EXPECT_EQ(one.sheets.sheets[i].bend, many.sheets.sheets[i].bend);
  }
}

/// Sheets of some of 40 nodes, each at its number.
NodeSheets numbered_sheets(std::initializer_list<std::uint32_t> rests) {
  NodeSheets fitted;
  for (const std::uint32_t rest : rests) {
    for (std::uint32_t i = rest; i < 40; i += 4) {
      Sheet sheet;
      sheet.frame = frame_along({static_cast<double>(i), 0, 0}, {0, 0, 1});
      sheet.variance = 1;
      sheet.radius = 1;
      sheet.valid = true;
      fitted.sheets.push_back(sheet);
      fitted.nodes.push_back(i);
    }
  }
  fitted.even = 10;
  return fitted;
}

// Nodes that nothing can be fitted to leave no gap, wherever they are.
TEST(NodeFits, LeaveOutWhatCannotBeFitted) {
  std::vector<Vec3> normals(576, Vec3{0, 0, 1});
  for (const std::size_t i : {0U, 1U, 7U, 12U, 575U}) normals[i] = {};
  const Flat flat;
  const NodeLevels levels(nodes_of_points(flat.measured, flat.truth, normals), 1, sigma);
  const Survey survey = survey_nodes(levels, sigma, 2, {}, {});
  EXPECT_EQ(survey.sheets.nodes.size(), 286U);  // without 0 and 12
  EXPECT_EQ(survey.sheets.even, 286U);
  const std::vector<std::uint8_t> everywhere(576, 1);
  const NodeSheets all =
      fit_nodes(survey.scales, levels, everywhere, sigma, {2, 3, 1, 100}, {}, {});
  EXPECT_EQ(all.even, 190U);  // of 192
  for (std::size_t k = 0; k < all.nodes.size(); ++k) {
    EXPECT_EQ(all.nodes[k] % 3 == 0, k < all.even);
    EXPECT_FALSE(normals[all.nodes[k]] == Vec3{});
    EXPECT_EQ(all.sheets[k].place, flat.truth[all.nodes[k]]);
  }
}

TEST(SheetSet, KeepsTheEvenChoiceFirst) {
  const SheetSet set(numbered_sheets({0, 1}), 40);
  ASSERT_EQ(set.sheets().size(), 20U);
  EXPECT_EQ(set.even().order().size(), 10U);
  EXPECT_EQ(set.all().order().size(), 20U);
  for (std::uint32_t i = 0; i < 40; ++i) {
    if (i % 4 > 1) {
      EXPECT_EQ(set.of(i), SheetSet::none);
    } else {
      ASSERT_LT(set.of(i), 20U);
      EXPECT_EQ(set.sheets()[set.of(i)].place.x, i);
      EXPECT_EQ(set.of(i) < 10, i % 4 == 0);
    }
  }
  const SheetSet even(numbered_sheets({0}), 40);
  EXPECT_EQ(even.all().order().size(), 10U);
}

}  // namespace
}  // namespace deburr

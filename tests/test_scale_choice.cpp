// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "scale_choice.hpp"
#include "support/compare.hpp"
#include "support/fit_bench.hpp"

namespace deburr {
namespace {

constexpr std::size_t count = 4000;
const double spacing = 1 / std::sqrt(double{count});

std::vector<ScaleChoice> choices_on(const Sampled& truth, double sigma, double assumed) {
  const FitBench bench(truth, spacing, sigma, 2);
  // The fits are told of another noise than there is.
  const SheetFitter fitter(bench.levels, assumed);
  ScaleSurvey survey{bench.fine.places, bench.fine.normals, std::vector<ScaleCurve>(count), {}};
  for (std::size_t level = 0; level < node_levels; ++level) {
    survey.merged[level] = bench.levels.merged(level);
  }
  SheetFitter::Scratch scratch;
  for (std::uint32_t i = 0; i < count; ++i) (void)fitter.survey(i, scratch, survey.curves[i]);
  return ScaleChooser(survey, assumed).choose(bench.fine.places, bench.fine.normals);
}

double mean_scale(const std::vector<ScaleChoice>& choices) {
  return mean_of(choices.size(),
                 [&](std::size_t i) { return static_cast<double>(choices[i].scale); });
}

TEST(ScaleChoice, IsLargeOnAPlaneAndSmallerOnWaves) {
  for (const double noise : {0.3, 0.6}) {
    const double flat =
        mean_scale(choices_on(flat_square(count, 1), noise * spacing, noise * spacing));
    const double wavy =
        mean_scale(choices_on(wavy_square(count, 1), noise * spacing, noise * spacing));
    EXPECT_GT(flat, 10) << noise;
    EXPECT_LT(wavy, flat - 3) << noise;
  }
}

TEST(ScaleChoice, FindsTheNoiseOfThePlace) {
  const double sigma = 0.5 * spacing;
  for (const double factor : {0.85, 1.0, 1.3}) {
    const auto choices = choices_on(flat_square(count, 3), sigma, factor * sigma);
    EXPECT_NEAR(mean_of(count, [&](std::size_t i) { return choices[i].noise; }), sigma,
                0.06 * sigma)
        << factor;
  }
}

/// Curves of nodes whose fits have a variance that falls and residuals that rise with the scale.
struct MadeUp {
  std::vector<Vec3> normals = std::vector<Vec3>(400, Vec3{0, 0, 1});
  ScaleSurvey survey{flat_square(400, 4).points, normals, std::vector<ScaleCurve>(400), {1, 9, 81}};

  /// @param misfit  at the scales from `from` on
  MadeUp(std::size_t from, float misfit) {
    for (ScaleCurve& curve : survey.curves) {
      for (std::size_t s = 0; s < sheet_scales; ++s) {
        const double area = std::pow(1.5, static_cast<double>(s));
        curve.freedom[s] = static_cast<float>(120 * area);
        curve.variance[s] = static_cast<float>(0.2 / area);
        // The mean of nine points shows a misfit nine times as clearly.
        const auto seen = static_cast<float>(survey.merged[s / level_scales]) * misfit;
        curve.residual[s] = s < from ? 1 : 1 + seen;
        curve.curvature[s] = 1.25;
        if (curve.residual[s] > 3) break;  // a survey ends there
      }
    }
  }
  [[nodiscard]] std::vector<ScaleChoice> choose() const {
    return ScaleChooser(survey, 0.1).choose(survey.places, normals);
  }
};

TEST(ScaleChoice, IsTheLargestThatFits) {
  for (const ScaleChoice& choice : MadeUp(sheet_scales, 0).choose()) {
    ASSERT_EQ(choice.scale, sheet_scales - 1);
    ASSERT_NEAR(choice.noise, 0.1, 1e-9);
    ASSERT_NEAR(choice.curvature[5], 1.25, 1e-6);
  }
  for (const std::size_t from : {3U, 5U, 7U}) {
    for (const ScaleChoice& choice : MadeUp(from, 2).choose()) ASSERT_EQ(choice.scale, from - 1);
  }
}

// A misfit of 0.0001 does not weigh up against what a larger fit takes off the noise.
TEST(ScaleChoice, WeighsMisfitAgainstVariance) {
  for (const ScaleChoice& choice : MadeUp(5, 0.0001F).choose()) {
    ASSERT_EQ(choice.scale, sheet_scales - 1);
  }
}

// Residuals over the coarsest nodes exceed the noise by 0.35. Where those of the smallest coarse
// fits do so by 0.2, nodes are not pure; where by 0.05, the surface is bent.
TEST(ScaleChoice, KnowsImpureNodesFromAMisfitByTheSmallestCoarseFits) {
  for (const float smallest : {0.05F, 0.2F}) {
    MadeUp made(sheet_scales, 0);
    for (ScaleCurve& curve : made.survey.curves) {
      for (std::size_t s = level_scales; s < sheet_scales; ++s) {
        curve.residual[s] = s < 2 * level_scales ? 1 + smallest : 1.35F;
      }
    }
    const std::size_t expected = smallest < 0.1F ? 2 * level_scales - 1 : sheet_scales - 1;
    for (const ScaleChoice& choice : made.choose()) ASSERT_EQ(choice.scale, expected);
  }
}

// Residuals of means of nine show nine times the misfit: 0.45 of the noise, 0.05 of which count as
// such, are a ninth of that where a point is concerned.
TEST(ScaleChoice, KnowsThatMeansShowAMisfitMoreClearly) {
  for (const ScaleChoice& choice : MadeUp(level_scales, 0.05F).choose()) {
    ASSERT_EQ(choice.scale, 2 * level_scales - 1);
  }
}

TEST(ScaleChoice, DoesNotListenToTheOtherSide) {
  MadeUp made(3, 2);
  const MadeUp other(7, 2);
  for (std::size_t i = 0; i < 400; ++i) {
    if (i % 40 == 0) continue;
    made.survey.normals[i] = made.normals[i] = {0, 0, -1};
    made.survey.curves[i] = other.survey.curves[i];
  }
  const std::vector<ScaleChoice> choices = made.choose();
  for (std::size_t i = 0; i < 400; ++i) ASSERT_EQ(choices[i].scale, i % 40 == 0 ? 2U : 6U);
}

TEST(ScaleChoice, HasADefaultWithoutCurves) {
  MadeUp made(sheet_scales, 0);
  made.survey.curves.assign(400, {});
  for (const ScaleChoice& choice : made.choose()) {
    ASSERT_EQ(choice.noise, 0.1);
    ASSERT_LT(choice.scale, sheet_scales);
    ASSERT_LT(choice.curvature[0], 0);
  }
}

}  // namespace
}  // namespace deburr

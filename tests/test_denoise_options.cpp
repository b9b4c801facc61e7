// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "deburr/denoise.hpp"
#include "support/compare.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

using testing::HasSubstr;

/// What both methods say of options that were changed.
template <typename Change>
std::string error_after(const Change& change) {
  DenoiseOptions options;
  change(options.automatic, options.yadav2018);
  std::string errors;
  for (const Method method : {Method::Auto, Method::Yadav2018}) {
    options.method = method;
    errors += invalid_argument_of([&] { (void)denoise({}, options); });
  }
  return errors;
}

TEST(DenoiseOptions, NamesTheWrongOption) {
  const double nan = std::nan("");
  EXPECT_EQ(error_after([](auto&, auto&) {}), "");
  EXPECT_EQ(error_after([](auto& a, auto&) { a.strength = 0; }),
            "automatic.strength must be in [1, 5], got 0");
  EXPECT_EQ(error_after([](auto& a, auto&) { a.strength = 6; }),
            "automatic.strength must be in [1, 5], got 6");
  EXPECT_EQ(error_after([](auto& a, auto&) { a.noise = -1; }),
            "automatic.noise must be finite and >= 0, got -1");
  EXPECT_EQ(error_after([&](auto& a, auto&) { a.noise = nan; }),
            "automatic.noise must be finite and >= 0, got nan");
  EXPECT_EQ(error_after([](auto& a, auto&) { a.max_move = -0.5; }),
            "automatic.max_move must be finite and >= 0, got -0.5");
  EXPECT_EQ(error_after([](auto& a, auto&) { a.max_move = HUGE_VAL; }),
            "automatic.max_move must be finite and >= 0, got inf");
}

TEST(DenoiseOptions, NamesTheWrongOptionOfThePublishedMethod) {
  const double nan = std::nan("");
  EXPECT_EQ(error_after([](auto&, auto& y) { y.k = 2; }), "yadav2018.k must be >= 3, got 2");
  EXPECT_EQ(error_after([](auto&, auto& y) { y.rounds = -3; }),
            "yadav2018.rounds must be >= 0, got -3");
  EXPECT_EQ(error_after([](auto&, auto& y) { y.rho = 1; }),
            "yadav2018.rho must be in [0, 1), got 1");
  EXPECT_EQ(error_after([&](auto&, auto& y) { y.tau = nan; }),
            "yadav2018.tau must be in (0, 1), got nan");
  EXPECT_EQ(error_after([](auto&, auto& y) { y.damping = -1; }),
            "yadav2018.damping must be in [0, 1e6], got -1");
  EXPECT_EQ(error_after([](auto&, auto& y) { y.alpha = 0; }),
            "yadav2018.alpha must be in (0, 1], got 0");
  EXPECT_EQ(error_after([](auto&, auto& y) { y.epsilon = HUGE_VAL; }),
            "yadav2018.epsilon must be in (0, 1e6], got inf");
  EXPECT_EQ(error_after([](auto&, auto& y) { y.radius = -2; }),
            "yadav2018.radius must be in (0, 1e6], got -2");
}

TEST(DenoiseOptions, RefusesHalfTheNormalsAndNegativeThreads) {
  PointCloud cloud;
  cloud.points = random_points(9, 1);
  cloud.normals = {{0, 0, 1}};
  EXPECT_EQ(invalid_argument_of([&] { (void)denoise(cloud); }),
            "normals must have one entry per point (9), got 1");
  EXPECT_THAT(invalid_argument_of([] { (void)denoise({}, {}, {.threads = -2}); }),
              HasSubstr("threads must be in [0, 256], got -2"));
}

}  // namespace
}  // namespace deburr

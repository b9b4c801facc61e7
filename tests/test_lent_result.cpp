// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "lent_result.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

using ::testing::IsEmpty;

constexpr std::size_t count = 3000;
constexpr double max_move = 0.4;

/// Points that landed on their likeliest sheet, but for one of seven; some would have gone beyond
/// the bound. There are more shares than points.
struct Landed {
  std::vector<Vec3> measured = random_points(count, 1);
  Shares shares;
  AutomaticResult result;
  AutomaticInput input{measured, {}, 1, 1, max_move};

  Landed() {
    shares.places = random_points(count + 100, 2);
    shares.normals = random_points(count + 100, 3);
    const std::vector<Vec3> others = random_points(count, 4);
    for (std::size_t i = 0; i < count; ++i) {
      const bool elsewhere = i % 7 == 2;
      result.points.push_back(elsewhere ? others[i]
                                        : bounded(shares.places[i], measured[i], max_move));
      result.normals.push_back(i % 5 == 3 ? others[i] : shares.normals[i]);
    }
  }
};

TEST(LentResult, IsTheSameBitsWhenItIsBack) {
  Landed landed;
  const AutomaticResult before = landed.result;
  ASSERT_NE(before.points[0], landed.shares.places[0]);  // beyond the bound
  const LentResult lent(landed.input, landed.shares, landed.result, {.threads = 3});
  EXPECT_THAT(landed.result.points, IsEmpty());
  EXPECT_EQ(landed.result.normals.capacity(), 0);
  lent.give_back(landed.shares.places, landed.shares.normals, landed.result, {.threads = 3});
  EXPECT_EQ(landed.result.points, before.points);
  EXPECT_EQ(landed.result.normals, before.normals);
}

}  // namespace
}  // namespace deburr

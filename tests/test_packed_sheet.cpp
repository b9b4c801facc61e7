// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "packed_sheet.hpp"
#include "random.hpp"
#include "support/random_sheet.hpp"

namespace deburr {
namespace {

TEST(PackedSheet, MeetsPointsWhereTheSheetDoes) {
  Random random(1);
  for (const double unit : {1.0, 1e-20, 1e20}) {
    for (int round = 0; round < 200; ++round) {
      const Sheet sheet = random_sheet(random, 3, unit);
      const PackedSheet packed = sheet;
      EXPECT_TRUE(packed.valid);
      EXPECT_EQ(packed.place, sheet.frame.origin);
      EXPECT_LT(norm(packed.middle() - sheet.middle()), 1e-6 * unit);
      EXPECT_LT(norm(packed.unit_normal() - sheet.normal()), 1e-6);
      EXPECT_NEAR(norm(packed.unit_normal()), 1, 1e-15);
      EXPECT_NEAR(packed.certainty * packed.certainty * sheet.variance, 1, 1e-12);
      EXPECT_NEAR(packed.per_radius() * sheet.radius, 1, 1e-6);
      const Vec3 p = sheet.frame.origin + sheet.radius * random_place(random);
      const Sheet::Meeting is = packed.meet(p);
      const Sheet::Meeting was = sheet.meet(p);
      EXPECT_NEAR(is.distance, was.distance, 1e-6 * unit);
      EXPECT_LT(norm(is.normal - was.normal), 1e-6);
    }
  }
}

// Places of sheets go into trees.
TEST(PackedSheet, IsValidOnlyIfFinite) {
  Random random(2);
  const Sheet sheet = random_sheet(random, 3, 1);
  Sheet none = sheet;
  none.valid = false;
  EXPECT_FALSE(PackedSheet(none).valid);
  for (const double bad : {0.0, std::numeric_limits<double>::quiet_NaN()}) {
    Sheet broken = sheet;
    broken.radius = bad;
    EXPECT_FALSE(PackedSheet(broken).valid) << bad;
    broken = sheet;
    broken.variance = bad;
    EXPECT_FALSE(PackedSheet(broken).valid) << bad;
  }
  Sheet far = sheet;
  far.height.c[0] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(PackedSheet(far).valid);
}

}  // namespace
}  // namespace deburr

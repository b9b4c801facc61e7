// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "belonging.hpp"
#include "sheet_blend.hpp"
#include "support/random_sheet.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

constexpr BlendScales scales{.noise = 0.2, .spacing = 1};

/// Sheets around a place.
struct Around {
  std::vector<Sheet> sheets;
  std::vector<PackedSheet> packed;
  std::vector<Found> near;

  void add(const Vec3& place, const Sheet& sheet) {
    const double square = squared_norm(sheet.frame.origin - place);
    near.push_back({square, static_cast<std::uint32_t>(sheets.size())});
    std::sort(near.begin(), near.end());
    sheets.push_back(sheet);
    packed.emplace_back(sheet);
  }
  [[nodiscard]] Blend blend(const Vec3& point, const Vec3& place, std::uint32_t own) const {
    return blend_sheets(point, place, own, near, packed, scales);
  }
};

/// The formula of docs/method/automatic.md as it stands.
Blend one_by_one(const Around& around, const Vec3& point, const Vec3& place, std::uint32_t own) {
  Vec3 move;
  Vec3 normals;
  double total = 0;
  const Sheet::Meeting at_own = around.sheets[own].meet(place);
  for (const Found& f : around.near) {
    const Sheet& sheet = around.sheets[f.index];
    double w = std::max(0.0, 1 - f.squared_distance / (0.49 * sheet.radius * sheet.radius));
    if (f.index == own) w = std::max(w, 0.1);
    const Sheet::Meeting here = sheet.meet(place);
    const double off = here.distance / height_reach(scales.noise, scales.spacing);
    w *= w * belonging(squared_norm(here.normal - at_own.normal), off) / sheet.variance;
    const Sheet::Meeting m = sheet.meet(point);
    move += (-w * m.distance) * m.normal;
    normals += w * m.normal;
    total += w;
  }
  if (!(total > 0)) return {};
  return {point + (1 / total) * move, unit(normals), true};
}

TEST(SheetBlend, IsTheSumOverTheSheetsAround) {
  Random random(3);
  std::size_t blended = 0;
  for (std::size_t count = 1; count <= 60; ++count) {
    const Vec3 place = 0.3 * random_place(random);
    const Vec3 point = place + 0.3 * random_place(random);
    Around around;
    for (std::size_t k = 0; k < count; ++k) around.add(place, random_sheet(random, 2, 1));
    const auto own = static_cast<std::uint32_t>(random.uniform() * static_cast<double>(count));
    const Blend is = around.blend(point, place, own);
    const Blend should_be = one_by_one(around, point, place, own);
    ASSERT_EQ(is.valid, should_be.valid) << count;
    blended += is.valid ? 1U : 0U;
    EXPECT_LT(norm(is.foot - should_be.foot), 1e-6) << count;
    EXPECT_LT(norm(is.normal - should_be.normal), 1e-6) << count;
  }
  EXPECT_GT(blended, 50U);
}

TEST(SheetBlend, IsNoneWithoutSheets) {
  Random random(4);
  Around around;
  around.add({}, random_sheet(random, 2, 1));
  EXPECT_TRUE(around.blend({}, around.sheets[0].middle(), 0).valid);
  around.near.clear();
  EXPECT_FALSE(around.blend({}, {}, 0).valid);
}

// What is not finite has no say, and does not end that of others.
TEST(SheetBlend, LeavesOutSheetsThatAreNotFinite) {
  Random random(5);
  Around around;
  Sheet flat;
  flat.frame = frame_along({}, {0, 0, 1});
  flat.variance = 0.01;
  flat.radius = 3;
  flat.valid = true;
  Sheet broken = flat;
  broken.height.c[4] = std::numeric_limits<double>::infinity();
  around.add({}, flat);
  for (int k = 0; k < 9; ++k) around.add({}, k % 2 == 0 ? broken : flat);
  const Blend blend = around.blend({0.1, 0, 0.2}, {0.1, 0, 0}, 0);
  ASSERT_TRUE(blend.valid);
  EXPECT_LT(norm(blend.foot - Vec3{0.1, 0, 0}), 1e-6);
  EXPECT_EQ(blend.normal, (Vec3{0, 0, 1}));
}

}  // namespace
}  // namespace deburr

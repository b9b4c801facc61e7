// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

#include "crease.hpp"
#include "support/shapes.hpp"

namespace deburr {
namespace {

/// Flat faces as exact sheets, one for each node; nodes are 1 apart.
class Faces {
 public:
  /// Nodes at corner + (i + 0.5) along + (j + 0.5) across.
  void add(const Vec3& corner, const Vec3& along, const Vec3& across, const Vec3& normal) {
    for (int i = 0; i < 8; ++i) {
      for (int j = 0; j < 8; ++j) {
        places_.push_back(corner + (i + 0.5) * along + (j + 0.5) * across);
        sheets_.push_back(flat(places_.back(), normal, variance()));
      }
    }
  }

  static double variance() { return 1e-4; }
  void set_variance(const Vec3& normal, double variance) {
    for (std::size_t k = 0; k < sheets_.size(); ++k) {
      if (dot(sheets_[k].unit_normal(), normal) > 0.99) {
        sheets_[k] = flat(places_[k], normal, variance);
      }
    }
  }

  /// Where a point comes to lie that belongs to the face with this normal.
  [[nodiscard]] Landing land(const Vec3& point, const Vec3& normal) const {
    const KdTree tree(places_);
    const BlendScales scales{.noise = 0.2, .spacing = 1};
    std::uint32_t own = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::uint32_t i = 0; i < places_.size(); ++i) {
      const double square = squared_norm(places_[i] - point);
      if (dot(sheets_[i].unit_normal(), normal) < 0.99 || square >= nearest) continue;
      nearest = square;
      own = i;
    }
    const Vec3 foot = point - dot(point - places_[own], normal) * normal;
    std::vector<Found> near;
    tree.nearest_to(foot, 100, std::numeric_limits<double>::infinity(), near);
    return CreaseFinder(sheets_, scales, 1).land(point, {foot, normal, true}, own, near);
  }

 private:
  static PackedSheet flat(const Vec3& place, const Vec3& normal, double variance) {
    Sheet sheet;
    sheet.frame = frame_along(place, normal);
    sheet.variance = variance;
    sheet.radius = 3;
    sheet.valid = true;
    return sheet;
  }

  std::vector<Vec3> places_;
  std::vector<PackedSheet> sheets_;
};

constexpr Vec3 up{0, 0, 1};

void expect_landing(const Landing& landing, const Vec3& place, Feature label) {
  EXPECT_LT(norm(landing.place - place), 1e-12)
      << landing.place.x << " " << landing.place.y << " " << landing.place.z;
  EXPECT_EQ(landing.label, label);
}

/// z = 0 for x < 0, and x = 0 above (1) or below (-1) it.
Faces two_faces(double side) {
  Faces faces;
  faces.add({0, -4, 0}, {-1, 0, 0}, {0, 1, 0}, up);
  faces.add({0, -4, 0}, {0, 0, side}, {0, 1, 0}, {-side, 0, 0});
  return faces;
}

TEST(Crease, EndsAFaceAtAConvexEdge) {
  const Faces faces = two_faces(-1);
  expect_landing(faces.land({0.3, 0.2, 0.1}, up), {0, 0.2, 0}, Feature::Edge);
  expect_landing(faces.land({0.1, 0.2, 0.3}, {1, 0, 0}), {0, 0.2, 0}, Feature::Edge);
  // This one is of the other face, which it was nearer to all along.
  const Landing there = faces.land({0.2, 0.2, -1.1}, up);
  expect_landing(there, {0, 0.2, -1.1}, Feature::Surface);
  EXPECT_EQ(there.normal, (Vec3{1, 0, 0}));
  expect_landing(faces.land({0.2, 0.2, -0.9}, up), {0, 0.2, -0.9}, Feature::Edge);
}

TEST(Crease, EndsAFaceAtAConcaveEdge) {
  const Faces faces = two_faces(1);
  expect_landing(faces.land({0.3, 0.2, -0.1}, up), {0, 0.2, 0}, Feature::Edge);
  expect_landing(faces.land({0.1, 0.2, -0.3}, {-1, 0, 0}), {0, 0.2, 0}, Feature::Edge);
  expect_landing(faces.land({0.2, 0.2, 1.1}, up), {0, 0.2, 1.1}, Feature::Surface);
}

TEST(Crease, LeavesThePointsOfAFaceOnIt) {
  for (const double side : {1.0, -1.0}) {
    const Faces faces = two_faces(side);
    expect_landing(faces.land({-0.5, 0.2, 0.1}, up), {-0.5, 0.2, 0}, Feature::Edge);
    expect_landing(faces.land({-1.2, 0.2, 0.1}, up), {-1.2, 0.2, 0}, Feature::Surface);
    expect_landing(faces.land({-5, 0.2, -0.3}, up), {-5, 0.2, 0}, Feature::Surface);
  }
}

/// The faces of x, y, z < 0 at the corner 0.
Faces three_faces() {
  Faces faces;
  faces.add({0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, up);
  faces.add({0, 0, 0}, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0});
  faces.add({0, 0, 0}, {0, -1, 0}, {0, 0, -1}, {1, 0, 0});
  return faces;
}

TEST(Crease, EndsThreeFacesInACorner) {
  const Faces faces = three_faces();
  for (const Vec3& normal : {up, Vec3{0, 1, 0}, Vec3{1, 0, 0}}) {
    expect_landing(faces.land({0.3, 0.2, 0.1}, normal), {0, 0, 0}, Feature::Corner);
  }
  // What is near a corner but not in it is up to those around: see corners.hpp.
  expect_landing(faces.land({-0.7, -0.7, 0.1}, up), {-0.7, -0.7, 0}, Feature::Edge);
  expect_landing(faces.land({0.3, -3.5, 0.1}, up), {0, -3.5, 0}, Feature::Edge);
  expect_landing(faces.land({-3.5, -3.5, 0.1}, up), {-3.5, -3.5, 0}, Feature::Surface);
}

TEST(Crease, IsNoneBetweenParallelSheets) {
  for (const double side : {1.0, -1.0}) {
    Faces faces;
    faces.add({4, -4, 0}, {-1, 0, 0}, {0, 1, 0}, up);
    faces.add({4, -4, -0.6}, {-1, 0, 0}, {0, 1, 0}, {0, 0, side});
    expect_landing(faces.land({0.1, 0.2, 0.3}, up), {0.1, 0.2, 0}, Feature::Surface);
    expect_landing(faces.land({0.1, 0.2, -0.25}, up), {0.1, 0.2, 0}, Feature::Surface);
  }
}

/// The shares of a landing, first of its own sheet.
std::vector<double> shares_of(const Landing& landing) {
  std::vector<double> shares;
  for (std::size_t k = 0; k < landing.sheet_count; ++k) {
    shares.push_back(landing.sheets.at(k).share);
  }
  return shares;
}

TEST(Crease, SharesAPointAmongTheSheetsThatItMayBeOf) {
  for (const double side : {1.0, -1.0}) {
    const Faces faces = two_faces(side);
    // As far from both, on either side of the edge.
    for (const double h : {0.1, -0.1}) {
      const Landing landing = faces.land({h, 0.2, -side * h}, up);
      const std::vector<double> shares = shares_of(landing);
      ASSERT_EQ(shares.size(), 2U);
      EXPECT_NEAR(shares[0], 0.5, 1e-9);
      EXPECT_NEAR(shares[1], 0.5, 1e-9);
      EXPECT_EQ(landing.sheets[0].normal, up);
      EXPECT_EQ(landing.sheets[1].normal, (Vec3{-side, 0, 0}));
    }
    // Clear of the edge by five times the noise.
    EXPECT_GT(shares_of(faces.land({-1, 0.2, 0.1}, up))[0], 0.999);
    EXPECT_EQ(shares_of(faces.land({-5, 0.2, 0.1}, up)), std::vector<double>{1});
  }
  EXPECT_EQ(shares_of(three_faces().land({0.1, 0.1, 0.1}, up)).size(), 3U);
}

// No sheet has a place for a point beyond where it ends.
TEST(Crease, PutsFeetOntoTheEdgeBeyondIt) {
  const Landing landing = two_faces(-1).land({0.1, 0.2, 0.15}, up);
  ASSERT_EQ(landing.sheet_count, 2U);
  EXPECT_LT(norm(landing.sheets[0].foot - Vec3{0, 0.2, 0}), 1e-12);
  EXPECT_LT(norm(landing.sheets[1].foot - Vec3{0, 0.2, 0}), 1e-12);
  const Landing below = two_faces(-1).land({0.1, 0.2, -0.15}, up);
  EXPECT_LT(norm(below.sheets[1].foot - Vec3{0, 0.2, -0.15}), 1e-12);
}

// Sheets of a few points that agree by chance have thirty times the variance of those around.
TEST(Crease, IsNoneOfSheetsThatAreFarLessSure) {
  Faces faces = two_faces(-1);
  const double limit = 30 * Faces::variance();
  faces.set_variance({1, 0, 0}, 0.9 * limit);
  expect_landing(faces.land({0.3, 0.2, 0.1}, up), {0, 0.2, 0}, Feature::Edge);
  faces.set_variance({1, 0, 0}, 1.1 * limit);
  expect_landing(faces.land({0.3, 0.2, 0.1}, up), {0.3, 0.2, 0}, Feature::Surface);
}

// Their planes meet, but the faces are far from there.
TEST(Crease, NeedsFacesThatComeNearEachOther) {
  Faces faces;
  faces.add({0, -4, 0}, {-1, 0, 0}, {0, 1, 0}, up);
  faces.add({0, -4, -5}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0});
  expect_landing(faces.land({0.3, 0.2, 0.1}, up), {0.3, 0.2, 0}, Feature::Surface);
}

// A bend of 20 degrees is one surface.
TEST(Crease, IsNoneInAGentleBend) {
  Faces faces;
  faces.add({0, -4, 0}, {-1, 0, 0}, {0, 1, 0}, up);
  const double c = 0.9396926207859084;
  const double s = 0.3420201433256687;
  faces.add({0, -4, 0}, {c, 0, -s}, {0, 1, 0}, {s, 0, c});
  expect_landing(faces.land({0.3, 0.2, 0.1}, up), {0.3, 0.2, 0}, Feature::Surface);
}

}  // namespace
}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "corners.hpp"

#include <algorithm>
#include <cmath>

#include "kd_tree.hpp"
#include "parallel.hpp"
#include "three_planes.hpp"
#include "unit.hpp"

namespace deburr {
namespace {

constexpr double around = 2.5;       ///< spacings from a point to those that have a say
constexpr double least_share = 0.2;  ///< of the points around, that must know of a sheet
constexpr double fewest = 3;
constexpr double corner_width = 1.4;  ///< spacings from a corner to points that are labelled as it

/// A sheet that several edge points know of, as a plane: dot(normal, x) = offset for x seen from
/// the point that asks.
struct Plane {
  Vec3 normal;
  double offset = 0;
  double votes = 0;
};

std::vector<Plane> planes_around(std::span<const EdgePoint> edges, std::span<const Found> found,
                                 const Vec3& at) {
  std::vector<Plane> planes;
  for (const Found& f : found) {
    const EdgePoint& edge = edges[f.index];
    for (std::size_t k = 0; k < edge.count; ++k) {
      const CutSheet& sheet = edge.sheets[k];
      const double offset = dot(sheet.normal, sheet.foot - at);
      auto known = std::ranges::find_if(planes, [&](const Plane& plane) {
        return dot(plane.normal, sheet.normal) > same_sheet * norm(plane.normal);
      });
      if (known == planes.end()) known = planes.insert(known, Plane{});
      known->normal += sheet.normal;
      known->offset += offset;
      known->votes += 1;
    }
  }
  const double least = std::max(fewest, least_share * static_cast<double>(found.size()));
  std::erase_if(planes, [&](const Plane& plane) { return plane.votes < least; });
  for (Plane& plane : planes) {
    const double length = norm(plane.normal);
    plane.normal = (1 / length) * plane.normal;
    plane.offset /= length;
  }
  return planes;
}

/// Whether three of the planes meet within a distance of 0.
bool meet_within(std::span<const Plane> planes, double distance) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      if (dot(planes[i].normal, planes[j].normal) > other_sheet) continue;
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        if (dot(planes[i].normal, planes[k].normal) > other_sheet ||
            dot(planes[j].normal, planes[k].normal) > other_sheet) {
          continue;
        }
        const auto place = three_planes_meet(planes[i].normal, planes[i].offset, planes[j].normal,
                                             planes[j].offset, planes[k].normal, planes[k].offset);
        if (place && norm(*place) < distance) return true;
      }
    }
  }
  return false;
}

}  // namespace

void label_corners(std::span<const EdgePoint> edges, Points places, double spacing,
                   std::vector<Feature>& labels, const Execution& execution) {
  std::vector<Vec3> at(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) at[e] = places[edges[e].point];
  const KdTree tree(at, execution);
  parallel_blocks(edges.size(), execution, [&](std::size_t begin, std::size_t end) {
    std::vector<Found> found;
    for (std::size_t e = begin; e < end; ++e) {
      tree.within_of(at[e], around * around * spacing * spacing, found);
      if (meet_within(planes_around(edges, found, at[e]), corner_width * spacing)) {
        labels[edges[e].point] = Feature::Corner;
      }
    }
  });
}

}  // namespace deburr

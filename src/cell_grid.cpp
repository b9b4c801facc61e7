// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "cell_grid.hpp"

#include <algorithm>
#include <cmath>

#include "box.hpp"
#include "columns.hpp"
#include "lanes.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

constexpr double most_along = 1 << 20;

/// Cells that are kept for each point, at most.
constexpr double most_cells = 16;
constexpr double most_cells_at_all = 4e9;  ///< their numbers have 32 bits

/// Squares and cubes of the radius must stay far from overflow and underflow.
constexpr double smallest_radius = 1e-100;
constexpr double largest_radius = 1e100;

/// A search that meets so many times the points that are wanted is left to the k-d tree.
constexpr double most_waste = 4;

/// More pairs within single cells than this are left to the tree, which counts without looking.
constexpr double most_cell_pairs = 4e9;

}  // namespace

std::optional<CellGrid> CellGrid::make(Points points, double radius, std::size_t max_count,
                                       const Execution& execution) {
  if (points.empty() || !(radius >= smallest_radius) || !(radius <= largest_radius)) return {};
  const Box box = bounding_box(points);
  const Vec3 half = half_extent(box);
  CellGrid grid;
  grid.squared_radius_ = radius * radius;
  const double width = radius * (1 + cell_excess);
  const auto along = [&](double half_side) { return std::floor(2 * (half_side / width)) + 2; };
  const std::array sides{along(half.x), along(half.y), along(half.z)};
  if (!(*std::max_element(sides.begin(), sides.end()) <= most_along)) return {};
  const auto count = static_cast<double>(points.size());
  if (sides[0] * sides[1] * sides[2] > std::min(most_cells * count + 64, most_cells_at_all)) {
    return {};
  }
  grid.per_cell_ = 1 / width;
  grid.axes_ = {Axis{box.low.x, static_cast<std::uint32_t>(sides[0])},
                Axis{box.low.y, static_cast<std::uint32_t>(sides[1])},
                Axis{box.low.z, static_cast<std::uint32_t>(sides[2])}};
  grid.sort_points(points, execution);
  const double pairs = grid.squared_occupancy();
  const double wanted = most_waste * count * static_cast<double>(max_count);
  if (pairs > most_cell_pairs || (max_count > 0 && pairs > wanted)) return {};
  return grid;
}

void CellGrid::sort_points(Points points, const Execution& execution) {
  const std::size_t rows = std::size_t{axes_[1].cells} * axes_[2].cells;
  resize_column(begins_, rows * axes_[0].cells + 1, execution);
  auto cells = make_column<std::uint32_t>(points.size(), execution);
  const auto along = [&](double v, const Axis& axis) {
    return std::min(static_cast<std::uint32_t>((v - axis.low) * per_cell_), axis.cells - 1);
  };
  parallel_for(points.size(), execution, [&](std::size_t i) {
    const Vec3& p = points[i];
    cells[i] = (along(p.z, axes_[2]) * axes_[1].cells + along(p.y, axes_[1])) * axes_[0].cells +
               along(p.x, axes_[0]);
  });
  for (const std::uint32_t c : cells) ++begins_[c];
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : begins_) {
    sum += begin;
    begin = sum;
  }
  resize_column(index_, points.size(), execution);
  for (std::size_t i = points.size(); i-- > 0;) {
    index_[--begins_[cells[i]]] = static_cast<std::uint32_t>(i);
  }
  for (std::vector<double>* const v : {&x_, &y_, &z_}) {
    resize_column(*v, points.size() + lane_count, execution);
  }
  parallel_for(points.size(), execution, [&](std::size_t slot) {
    const Vec3& p = points[index_[slot]];
    x_[slot] = p.x;
    y_[slot] = p.y;
    z_[slot] = p.z;
  });
}

double CellGrid::squared_occupancy() const {
  double sum = 0;
  for (std::size_t c = 0; c + 1 < begins_.size(); ++c) {
    const double points = begins_[c + 1] - begins_[c];
    sum += points * points;
  }
  return sum;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "box.hpp"
#include "distance_sort.hpp"
#include "lanes.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

/// A cell is by so much wider than the radius, that rounding cannot move a neighbour
/// beyond the cells that are searched: coordinates in cells are off by less than
/// 3 * 2^-53 * most_along < 1e-9.
constexpr double wider = 1e-6;
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

DEBURR_LANES_INLINE Lanes load(const double* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

}  // namespace

/// The runs of slots in which the neighbours of the points of one cell are.
struct CellGrid::Runs {
  struct Run {
    std::uint32_t begin, end;
    double y, z;  ///< of the row of cells, in cells
  };
  std::array<Run, 9> runs;
  std::size_t count = 0;
  std::uint64_t cell = ~std::uint64_t{0};
  std::size_t candidates = 0;
};

std::optional<CellGrid> CellGrid::make(Points points, double radius, std::size_t max_count,
                                       const Execution& execution) {
  if (points.empty() || !(radius >= smallest_radius) || !(radius <= largest_radius)) return {};
  const Box box = bounding_box(points);
  const Vec3 half = half_extent(box);
  CellGrid grid;
  grid.squared_radius_ = radius * radius;
  const double width = radius * (1 + wider);
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

std::uint32_t CellGrid::along(double v, const Axis& axis) const {
  return std::min(static_cast<std::uint32_t>((v - axis.low) * per_cell_), axis.cells - 1);
}

void CellGrid::sort_points(Points points, const Execution& execution) {
  const std::size_t rows = std::size_t{axes_[1].cells} * axes_[2].cells;
  begins_.assign(rows * axes_[0].cells + 1, 0);
  std::vector<std::uint32_t> cells(points.size());
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
  index_.resize(points.size());
  for (std::size_t i = points.size(); i-- > 0;) {
    index_[--begins_[cells[i]]] = static_cast<std::uint32_t>(i);
  }
  for (std::vector<double>* const v : {&x_, &y_, &z_}) v->resize(points.size() + lane_count);
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

void CellGrid::set_runs(std::size_t slot, Runs& runs) const {
  const std::uint32_t cx = along(x_[slot], axes_[0]);
  const std::uint32_t cy = along(y_[slot], axes_[1]);
  const std::uint32_t cz = along(z_[slot], axes_[2]);
  const std::uint64_t cell = (std::uint64_t{cz} << 42U) | (std::uint64_t{cy} << 21U) | cx;
  if (cell == runs.cell) return;
  runs.cell = cell;
  runs.count = 0;
  runs.candidates = 0;
  const auto first = [&](std::uint32_t c) { return c - std::min(c, 1U); };
  const auto last = [&](std::uint32_t c, const Axis& axis) {
    return std::min(c + 1, axis.cells - 1);
  };
  for (std::uint32_t z = first(cz); z <= last(cz, axes_[2]); ++z) {
    for (std::uint32_t y = first(cy); y <= last(cy, axes_[1]); ++y) {
      const std::size_t row = (std::size_t{z} * axes_[1].cells + y) * axes_[0].cells;
      const std::uint32_t begin = begins_[row + first(cx)];
      const std::uint32_t end = begins_[row + last(cx, axes_[0]) + 1];
      if (begin == end) continue;
      runs.runs[runs.count++] = {begin, end, static_cast<double>(y), static_cast<double>(z)};
      runs.candidates += end - begin;
    }
  }
}

namespace {

/// Squared distance from a place to a row of cells, all in cells, and not above the true one.
double squared_gap(double y, double z, double row_y, double row_z) {
  const double gap_y = std::max({row_y - y, y - row_y - 1, 0.0});
  const double gap_z = std::max({row_z - z, z - row_z - 1, 0.0});
  return gap_y * gap_y + gap_z * gap_z - 8 * wider;
}

/// Squared distances of eight points from (x, y, z), as squared_norm() of the difference.
DEBURR_LANES_INLINE Lanes squared_distances(const double* x, const double* y, const double* z,
                                            const Lanes3& at) {
  const Lanes3 d = Lanes3{load(x), load(y), load(z)} - at;
  return dot(d, d);
}

/// Number of the slots [begin, end) within the radius.
DEBURR_MULTIVERSION
std::int64_t count_run(const double* x, const double* y, const double* z, std::size_t count,
                       const Vec3& place, double squared_radius) {
  const Lanes3 at = all_lanes(place);
  LaneBits near{};
  std::size_t k = 0;
  for (; k + lane_count <= count; k += lane_count) {
    near += squared_distances(x + k, y + k, z + k, at) <= squared_radius;
  }
  if (k < count) {
    const LaneBits there = present(count, k) > 0.0;
    near += (squared_distances(x + k, y + k, z + k, at) <= squared_radius) & there;
  }
  std::int64_t sum = 0;
  for (std::size_t l = 0; l < lane_count; ++l) sum -= near[l];
  return sum;
}

/// Appends those of the slots within the radius; returns how many there are then.
DEBURR_MULTIVERSION
std::size_t append_run(const double* x, const double* y, const double* z,
                       const std::uint32_t* index, std::size_t count, const Vec3& place,
                       double squared_radius, double* squared_distances_found,
                       std::uint32_t* indices_found, std::size_t size) {
  const Lanes3 at = all_lanes(place);
  for (std::size_t k = 0; k < count; k += lane_count) {
    std::array<double, lane_count> squared;
    const Lanes d = squared_distances(x + k, y + k, z + k, at);
    std::memcpy(squared.data(), &d, sizeof d);
    const std::size_t lanes = std::min(lane_count, count - k);
    for (std::size_t l = 0; l < lanes; ++l) {
      // Written over by the next one if too far.
      squared_distances_found[size] = squared[l];
      indices_found[size] = index[k + l];
      size += squared[l] <= squared_radius ? 1U : 0U;
    }
  }
  return size;
}

}  // namespace

void CellGrid::count(std::size_t begin, std::size_t end, std::size_t* counts) const {
  Runs runs;
  for (std::size_t slot = begin; slot < end; ++slot) {
    set_runs(slot, runs);
    const Vec3 at{x_[slot], y_[slot], z_[slot]};
    const double y = (at.y - axes_[1].low) * per_cell_;
    const double z = (at.z - axes_[2].low) * per_cell_;
    std::int64_t near = -1;  // the point itself
    for (std::size_t r = 0; r < runs.count; ++r) {
      const Runs::Run& run = runs.runs[r];
      if (squared_gap(y, z, run.y, run.z) > 1) continue;
      near += count_run(&x_[run.begin], &y_[run.begin], &z_[run.begin], run.end - run.begin, at,
                        squared_radius_);
    }
    counts[slot - begin] = static_cast<std::size_t>(near);
  }
}

void CellGrid::find(std::span<const Query> queries) const {
  Runs runs;
  DistanceSort sort(squared_radius_);
  for (const Query& query : queries) find_one(query.slot, query.wanted, query.to, runs, sort);
}

void CellGrid::find_one(std::size_t slot, std::size_t wanted, std::uint32_t* to, Runs& runs,
                        DistanceSort& sort) const {
  set_runs(slot, runs);
  sort.reserve(runs.candidates + 1);
  const Vec3 at{x_[slot], y_[slot], z_[slot]};
  const double y = (at.y - axes_[1].low) * per_cell_;
  const double z = (at.z - axes_[2].low) * per_cell_;
  std::size_t size = 0;
  for (std::size_t r = 0; r < runs.count; ++r) {
    const Runs::Run& run = runs.runs[r];
    if (squared_gap(y, z, run.y, run.z) > 1) continue;
    size = append_run(&x_[run.begin], &y_[run.begin], &z_[run.begin], &index_[run.begin],
                      run.end - run.begin, at, squared_radius_, sort.squared_distances(),
                      sort.indices(), size);
  }
  sort.write(size, index_[slot], wanted, to);
}

}  // namespace deburr

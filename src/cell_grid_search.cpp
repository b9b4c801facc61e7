// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "cell_grid.hpp"
#include "distance_sort.hpp"
#include "lanes.hpp"

namespace deburr {

void CellGrid::set_runs(const Vec3& at, Runs& runs) const {
  // Of a place outside the grid, the cell next to it.
  const auto along = [&](double v, const Axis& axis) {
    return static_cast<std::uint32_t>(
        std::clamp((v - axis.low) * per_cell_, 0.0, static_cast<double>(axis.cells - 1)));
  };
  const std::uint32_t cx = along(at.x, axes_[0]);
  const std::uint32_t cy = along(at.y, axes_[1]);
  const std::uint32_t cz = along(at.z, axes_[2]);
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

DEBURR_LANES_INLINE Lanes load(const double* from) {
  Lanes v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// Squared distance from a place to a row of cells, all in cells, and not above the true one.
double squared_gap(double y, double z, double row_y, double row_z) {
  const double gap_y = std::max({row_y - y, y - row_y - 1, 0.0});
  const double gap_z = std::max({row_z - z, z - row_z - 1, 0.0});
  return gap_y * gap_y + gap_z * gap_z - 8 * cell_excess;
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
    const Vec3 at = place(slot);
    set_runs(at, runs);
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

/// All within the radius of a place, one of them itself if it is that of a point.
/// @param space  with room for all candidates and one more
std::size_t CellGrid::gather(const Vec3& at, const Runs& runs, const Space& space) const {
  const double y = (at.y - axes_[1].low) * per_cell_;
  const double z = (at.z - axes_[2].low) * per_cell_;
  std::size_t size = 0;
  for (std::size_t r = 0; r < runs.count; ++r) {
    const Runs::Run& run = runs.runs[r];
    if (squared_gap(y, z, run.y, run.z) > 1) continue;
    size = append_run(&x_[run.begin], &y_[run.begin], &z_[run.begin], &index_[run.begin],
                      run.end - run.begin, at, squared_radius_, space.squared_distances,
                      space.indices, size);
  }
  return size;
}

void CellGrid::find(std::span<const Query> queries) const {
  Runs runs;
  DistanceSort sort(squared_radius_);
  for (const Query& query : queries) {
    const Vec3 at = place(query.slot);
    set_runs(at, runs);
    sort.reserve(runs.candidates + 1);
    const std::size_t size = gather(at, runs, {sort.squared_distances(), sort.indices()});
    sort.write(size, index_[query.slot], query.wanted, query.to);
  }
}

void CellGrid::nearest(std::size_t begin, std::size_t end, std::size_t count, Found* to) const {
  constexpr Found none{std::numeric_limits<double>::infinity(),
                       std::numeric_limits<std::uint32_t>::max()};
  Runs runs;
  DistanceSort space(squared_radius_);
  for (std::size_t slot = begin; slot < end; ++slot) {
    const Vec3 at = place(slot);
    set_runs(at, runs);
    space.reserve(runs.candidates + 1);
    const std::size_t size = gather(at, runs, {space.squared_distances(), space.indices()});
    Found* const best = to + (slot - begin) * count;
    std::fill(best, best + count, none);
    for (std::size_t k = 0; k < size; ++k) {
      const Found f{space.squared_distances()[k], space.indices()[k]};
      if (f.index == index_[slot] || !(f < best[count - 1])) continue;
      std::size_t rank = count - 1;
      for (; rank > 0 && f < best[rank - 1]; --rank) best[rank] = best[rank - 1];
      best[rank] = f;
    }
  }
}

void CellGrid::within_of(const Vec3& at, std::vector<Found>& found) const {
  thread_local std::vector<double> squared_distances;
  thread_local std::vector<std::uint32_t> indices;
  Runs runs;
  set_runs(at, runs);
  if (indices.size() <= runs.candidates) {
    squared_distances.resize(2 * runs.candidates + 1);
    indices.resize(2 * runs.candidates + 1);
  }
  const std::size_t size = gather(at, runs, {squared_distances.data(), indices.data()});
  found.clear();
  for (std::size_t k = 0; k < size; ++k) found.push_back({squared_distances[k], indices[k]});
}

}  // namespace deburr

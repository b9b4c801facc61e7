// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "sheet_samples.hpp"

#include <algorithm>

#include "sheet_kernels.hpp"

namespace deburr {

void SheetSamples::start(const SurfaceNodes& nodes, const Frame& frame,
                         std::span<const Found> found) {
  nodes_ = &nodes;
  frame_ = frame;
  found_ = found;
  filled_ = 0;
  summed_ = 0;
  const std::size_t blocks = (found.size() + lane_count - 1) / lane_count;
  if (blocks_.size() < blocks) blocks_.resize(blocks);
}

/// Makes ready the first `count` samples. The last block holds the last sample several times.
void SheetSamples::fill(std::size_t count) {
  if (count <= filled_) return;
  const std::size_t begin = filled_ / lane_count;
  const std::size_t end = (count + lane_count - 1) / lane_count;
  for (std::size_t k = filled_; k < end * lane_count; ++k) {
    Block& s = blocks_[k / lane_count];
    const std::size_t l = k % lane_count;
    const Found& f = found_[std::min(k, found_.size() - 1)];
    const Vec3& place = nodes_->places[f.index];
    s.x[l] = place.x;
    s.y[l] = place.y;
    s.place_height[l] = place.z;
    const Vec3& normal = nodes_->normals[f.index];
    s.u[l] = normal.x;
    s.v[l] = normal.y;
    s.w[l] = normal.z;
    const Vec3& measured = nodes_->measured[f.index];
    s.height[l] = measured.x;
    s.share[l] = measured.y;
    s.measured[l] = measured.z;
    s.weight[l] = nodes_->weight(f.index);
    s.trust[l] = nodes_->trust[f.index];
    s.square[l] = f.squared_distance;
  }
  filled_ = end * lane_count;
  Kernels::turn(std::span(blocks_).subspan(begin, end - begin), frame_);
}

std::size_t SheetSamples::count_within(double area) const {
  const auto end = std::ranges::upper_bound(found_, area, {}, &Found::squared_distance);
  return static_cast<std::size_t>(end - found_.begin());
}

void SheetSamples::sum(std::size_t count, const Membership& member, WeightedQuadric& sums) {
  fill(count);
  summed_ = (count + lane_count - 1) / lane_count;
  const auto& c = member.surface.c;
  const bool curved = c[3] != 0 || c[4] != 0 || c[5] != 0;
  if (curved) {
    Kernels::share_in_quadric(blocks_.data(), count, member);
  } else {
    Kernels::share_in_plane(blocks_.data(), count, member);
  }
  const auto all = Kernels::moments(std::span(blocks_).first(summed_), 1 / sums.scale());
  auto& to = sums.sums();
  std::copy_n(all.begin() + Kernels::normal, to.normal.size(), to.normal.begin());
  std::copy_n(all.begin() + Kernels::right, to.right.size(), to.right.begin());
  to.heights = all[Kernels::squared_heights];
  to.spread = all[Kernels::spread];
  to.shares = all[Kernels::shared];
  to.share_squares = all[Kernels::squared_shares];
  to.count = static_cast<std::size_t>(all[Kernels::used]);
}

double SheetSamples::variance(const HeightQuadric& pull) const {
  return Kernels::variance(std::span(blocks_).first(summed_), pull);
}

}  // namespace deburr

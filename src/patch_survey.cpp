// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "patch_survey.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "parallel.hpp"

namespace deburr {
namespace {

constexpr std::size_t most_places = 4096;
/// Points in a patch of the smallest size, and in the largest.
constexpr std::size_t fewest_points = 24;
constexpr std::size_t most_points = 8192;
/// No patch holds more than this share of the cloud.
constexpr std::size_t fewest_patches = 6;
/// Points in all patches of a size; there are fewer patches where they are large, and each of them
/// tells more. But never fewer than this, so that some lie clear of edges.
constexpr std::size_t work = std::size_t{1} << 17;
constexpr std::size_t fewest_places = 128;

/// The place in the middle of some points.
Vec3 middle_point(Points points, std::span<const std::uint32_t> some) {
  if (some.size() <= 2) {
    // Both are as far from their mean: rounding must not choose.
    const auto place = [&](std::uint32_t i) {
      return std::tie(points[i].x, points[i].y, points[i].z);
    };
    return points[*std::ranges::min_element(some, {}, place)];
  }
  const Vec3 origin = points[some.front()];
  Vec3 sum;
  for (const std::uint32_t i : some) sum += points[i] - origin;
  const Vec3 mean = origin + (1 / static_cast<double>(some.size())) * sum;
  const auto key = [&](std::uint32_t i) {
    const Vec3& p = points[i];
    return std::tuple(squared_norm(p - mean), p.x, p.y, p.z);
  };
  return points[*std::min_element(
      some.begin(), some.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); })];
}

/// One point of each cell that the k-d tree has at the depth of `cells` cells. A cell is a set of
/// points by their places alone, and rounding changes few of them. `order` is changed.
void sample_cells(Points points, std::span<std::uint32_t> order, std::size_t cells,
                  std::vector<Vec3>& sample) {
  if (cells == 1 || order.size() == 1) {
    sample.push_back(middle_point(points, order));
    return;
  }
  constexpr std::size_t leaf = 16;  // in the leaves of the tree there is no order
  if (order.size() <= leaf) {
    const auto key = [&](std::uint32_t i) {
      return std::tie(points[i].x, points[i].y, points[i].z);
    };
    std::ranges::sort(order, {}, key);
  }
  const std::size_t half = order.size() / 2;
  sample_cells(points, order.first(half), cells / 2, sample);
  sample_cells(points, order.subspan(half), cells / 2, sample);
}

}  // namespace

PatchSurvey::PatchSurvey(Points points, const KdTree& tree) : points_(points), tree_(tree) {
  if (points.empty()) return;
  std::vector<std::uint32_t> order = tree.order();
  sample_cells(points, order, most_places, sample_);
  feet_ = sample_;
}

std::size_t PatchSurvey::count(std::size_t size) const {
  const double growth = size % 2 == 0 ? 1 : std::sqrt(2.0);
  return static_cast<std::size_t>(growth * static_cast<double>(fewest_points << (size / 2)));
}

bool PatchSurvey::has_size(std::size_t size) const {
  return size == 0 ||
         (count(size) <= most_points && count(size) <= points_.size() / fewest_patches);
}

std::size_t PatchSurvey::stride(std::size_t size) const {
  std::size_t stride = 1;
  while (count(size) * (sample_.size() / stride) > work &&
         sample_.size() / (2 * stride) >= fewest_places) {
    stride *= 2;
  }
  return stride;
}

void PatchSurvey::add_size(const Execution& execution) {
  const std::size_t size = patches_.size();
  const std::size_t step = stride(size);
  std::vector<SurfacePatch> patches((sample_.size() + step - 1) / step);
  constexpr std::size_t block = 16;  // an item here is as much work as hundreds elsewhere
  parallel_blocks<block>(patches.size(), execution, [&](std::size_t begin, std::size_t end) {
    PatchFitter fitter(points_, tree_);
    for (std::size_t i = begin; i < end; ++i) patches[i] = fitter.fit(feet_[i * step], count(size));
  });
  patches_.push_back(std::move(patches));
}

}  // namespace deburr

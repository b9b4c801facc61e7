// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "kd_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "found_sort.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

constexpr std::uint32_t leaf_size = 12;

/// Nearest points so few are kept in order as they come; of more, the farthest are dropped now and
/// then.
constexpr std::size_t longest_list = 24;

constexpr std::uint32_t any_index = std::numeric_limits<std::uint32_t>::max();

/// A tree of so many points is built by one thread, and others from so many parts.
constexpr std::uint32_t small_tree = 8192;
constexpr std::size_t parts = 64;

/// Number of nodes of the trees of `count` and of `count + 1` points.
std::pair<std::uint32_t, std::uint32_t> node_counts(std::uint32_t count) {
  if (count < leaf_size) return {1, 1};
  const auto [half, more] = node_counts(count / 2);
  const std::uint32_t uneven = 1 + half + more;
  if (count % 2 != 0) return {uneven, 1 + 2 * more};
  return {count == leaf_size ? 1 : 1 + 2 * half, uneven};
}

}  // namespace

KdTree::KdTree(Points points, const Execution& execution)
    : points_(points), order_(points.size()), sorted_(points.size()) {
  if (points.empty()) return;
  std::iota(order_.begin(), order_.end(), 0U);
  nodes_.resize(node_counts(static_cast<std::uint32_t>(points.size())).first);
  build_all(without_progress(execution));
  parallel_for(order_.size(), without_progress(execution),
               [&](std::size_t i) { sorted_[i] = points_[order_[i]]; });
}

void KdTree::build_all(const Execution& execution) {
  std::vector<Range> level{{0, static_cast<std::uint32_t>(points_.size()), 0}};
  if (points_.size() > small_tree) {
    while (level.size() < parts) {
      std::vector<Range> next(2 * level.size());
      parallel_blocks<1>(level.size(), execution, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
          const auto halves = split(level[k], execution);
          std::ranges::copy(halves, next.begin() + static_cast<std::ptrdiff_t>(2 * k));
        }
      });
      level = std::move(next);
    }
  }
  parallel_blocks<1>(level.size(), execution, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) build(level[k], execution);
  });
}

void KdTree::build(const Range& range, const Execution& execution) {
  for (const Range& half : split(range, execution)) {
    if (half.begin < half.end) build(half, execution);
  }
}

std::array<KdTree::Range, 2> KdTree::split(const Range& range, const Execution& execution) {
  const auto [begin, end, self] = range;
  if (end - begin > block_size) check_cancelled(execution);
  Box box;
  std::uint32_t smallest = order_[begin];
  for (std::uint32_t i = begin; i < end; ++i) {
    box.add(points_[order_[i]]);
    smallest = std::min(smallest, order_[i]);
  }
  nodes_[self] = {box, begin, end, 0, smallest};
  if (end - begin <= leaf_size) return {};

  // Points at one place are split by index, so that a search among them ends early too.
  const Vec3 extent = half_extent(box);
  const double largest = std::max({extent.x, extent.y, extent.z});
  const double Vec3::*axis = extent.x == largest   ? &Vec3::x
                             : extent.y == largest ? &Vec3::y
                                                   : &Vec3::z;
  const std::uint32_t middle = begin + (end - begin) / 2;
  CancelWatch watch(execution);
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     watch();
                     const double va = points_[a].*axis;
                     const double vb = points_[b].*axis;
                     return va != vb ? va < vb : a < b;
                   });
  const std::uint32_t left = self + 1;
  const std::uint32_t right = left + node_counts(middle - begin).first;
  nodes_[self].right = right;
  return {Range{begin, middle, left}, Range{middle, end, right}};
}

/// Visits the points of every box that can hold a point up to `limit`, which visits may lower.
template <typename Visit>
void KdTree::search(std::uint32_t node, const Vec3& at, const Found& limit,
                    const Visit& visit) const {
  const Node& n = nodes_[node];
  if (n.right == 0) {
    for (std::uint32_t i = n.begin; i < n.end; ++i) {
      visit(Found{squared_norm(sorted_[i] - at), order_[i]});
    }
    return;
  }
  const std::uint32_t left = node + 1;
  const double to_left = squared_distance(at, nodes_[left].box);
  const double to_right = squared_distance(at, nodes_[n.right].box);
  const bool left_first = to_left <= to_right;
  const auto descend = [&](std::uint32_t child, double distance) {
    if (!(limit < Found{distance, nodes_[child].smallest})) search(child, at, limit, visit);
  };
  descend(left_first ? left : n.right, left_first ? to_left : to_right);
  descend(left_first ? n.right : left, left_first ? to_right : to_left);
}

void KdTree::nearest(const Vec3& at, std::uint32_t excluded, std::size_t count,
                     double squared_radius, std::vector<Found>& found) const {
  found.clear();
  if (count == 0 || nodes_.empty()) return;
  Found limit{squared_radius, any_index};
  if (count <= longest_list) {
    search(0, at, limit, [&](const Found& f) {
      if (f.index == excluded || limit < f) return;
      if (found.size() == count) found.pop_back();
      std::size_t to = found.size();
      found.push_back(f);
      for (; to > 0 && f < found[to - 1]; --to) found[to] = found[to - 1];
      found[to] = f;
      if (found.size() == count) limit = found.back();
    });
    return;
  }
  const auto keep = static_cast<std::ptrdiff_t>(count);
  const auto cut = [&] {
    std::nth_element(found.begin(), found.begin() + keep - 1, found.end());
    found.resize(count);
    limit = found.back();
  };
  const std::size_t most = 2 * count;
  search(0, at, limit, [&](const Found& f) {
    if (f.index == excluded || limit < f) return;
    found.push_back(f);
    if (found.size() == most) cut();
  });
  double farthest = 0;
  for (const Found& f : found) farthest = std::max(farthest, f.squared_distance);
  thread_local FoundSort sort;
  sort.sort(found, std::min(count, found.size()), farthest);
}

void KdTree::nearest_beside(const Vec3& at, std::size_t count, double& hint,
                            std::vector<Found>& found, std::uint32_t excluded) const {
  constexpr double no_limit = std::numeric_limits<double>::infinity();
  constexpr double margin = 1.4;
  nearest(at, excluded, count, hint, found);
  if (found.size() < count && hint < no_limit) nearest(at, excluded, count, no_limit, found);
  if (found.size() == count && count > 0) hint = margin * found.back().squared_distance;
}

void KdTree::within(const Vec3& at, std::uint32_t excluded, double squared_radius,
                    std::vector<Found>& found) const {
  found.clear();
  if (nodes_.empty()) return;
  const Found limit{squared_radius, any_index};
  search(0, at, limit, [&](const Found& f) {
    if (f.squared_distance <= squared_radius && f.index != excluded) found.push_back(f);
  });
  std::sort(found.begin(), found.end());
}

void KdTree::nearest(std::uint32_t query, std::size_t count, double squared_radius,
                     std::vector<Found>& found) const {
  nearest(points_[query], query, count, squared_radius, found);
}

void KdTree::within(std::uint32_t query, double squared_radius, std::vector<Found>& found) const {
  within(points_[query], query, squared_radius, found);
}

void KdTree::nearest_to(const Vec3& at, std::size_t count, double squared_radius,
                        std::vector<Found>& found, std::uint32_t excluded) const {
  nearest(at, excluded, count, squared_radius, found);
}

void KdTree::within_of(const Vec3& at, double squared_radius, std::vector<Found>& found) const {
  within(at, no_point, squared_radius, found);
}

Found KdTree::nearest_to(const Vec3& at) const {
  Found best{std::numeric_limits<double>::infinity(), any_index};
  search(0, at, best, [&](const Found& f) { best = std::min(best, f); });
  return best;
}

std::size_t KdTree::count_within(std::uint32_t query, double squared_radius) const {
  if (nodes_.empty()) return 0;
  const Vec3& at = points_[query];
  std::size_t count = 0;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t node = open.back();
    const Node& n = nodes_[node];
    open.pop_back();
    if (squared_distance(at, n.box) > squared_radius) continue;
    if (squared_distance_to_farthest(at, n.box) <= squared_radius) {
      count += n.end - n.begin;
    } else if (n.right == 0) {
      for (std::uint32_t i = n.begin; i < n.end; ++i) {
        count += squared_norm(sorted_[i] - at) <= squared_radius ? 1 : 0;
      }
    } else {
      open.push_back(node + 1);
      open.push_back(n.right);
    }
  }
  return count - 1;  // the query itself
}

}  // namespace deburr

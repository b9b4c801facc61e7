// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "kd_tree.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "columns.hpp"
#include "found_sort.hpp"
#include "halves.hpp"
#include "parallel.hpp"
#include "tree_layout.hpp"

namespace deburr {
namespace {

constexpr std::uint32_t leaf_size = 16;

/// Nearest points so few are kept in order as they come; of more, the farthest are dropped now and
/// then.
constexpr std::size_t longest_list = 24;

constexpr std::uint32_t any_index = std::numeric_limits<std::uint32_t>::max();

}  // namespace

KdTree::KdTree(Points points, const Execution& execution) : points_(points) {
  TreeLayout layout = lay_out_tree(points, leaf_size, execution);
  order_ = std::move(layout.order);
  const Execution quiet = without_progress(execution);
  resize_column(sorted_, order_.size(), quiet);
  resize_column(nodes_, layout.ranges.size(), quiet);
  parallel_for(nodes_.size(), quiet, [&](std::size_t k) {
    const auto& [begin, end, right] = layout.ranges[k];
    Node& node = nodes_[k];
    node = {{}, begin, end, right, any_index};
    if (right != 0) return;
    for (std::uint32_t i = begin; i < end; ++i) {
      sorted_[i] = points[order_[i]];
      node.box.add(sorted_[i]);
      node.smallest = std::min(node.smallest, order_[i]);
    }
  });
  // Children come after their parent.
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    Node& node = nodes_[k];
    if (node.right == 0) continue;
    for (const Node* const child : {&nodes_[k + 1], &nodes_[node.right]}) {
      node.box.add(child->box);
      node.smallest = std::min(node.smallest, child->smallest);
    }
  }
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

void KdTree::runs_within(const Vec3& at, double squared_radius, std::vector<Run>& runs) const {
  runs.clear();
  if (!nodes_.empty()) add_runs(0, at, squared_radius, runs);
}

void KdTree::add_runs(std::uint32_t node, const Vec3& at, double squared_radius,
                      std::vector<Run>& runs) const {
  const Node& n = nodes_[node];
  if (squared_distance(at, n.box) > squared_radius) return;
  if (n.right != 0 && squared_distance_to_farthest(at, n.box) > squared_radius) {
    add_runs(node + 1, at, squared_radius, runs);
    add_runs(n.right, at, squared_radius, runs);
  } else if (!runs.empty() && runs.back().end == n.begin) {
    runs.back().end = n.end;
  } else {
    runs.push_back({n.begin, n.end});
  }
}

std::vector<std::uint32_t> KdTree::groups(std::size_t most) const {
  std::vector<std::uint32_t> begins;
  std::uint32_t end = 0;  // of what is in a group already
  for (const Node& n : nodes_) {
    if (n.begin < end || (n.right != 0 && n.end - n.begin > most)) continue;
    add_halves(n.begin, n.end, most, begins);
    end = n.end;
  }
  begins.push_back(end);
  return begins;
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

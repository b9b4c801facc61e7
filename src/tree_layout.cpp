// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "tree_layout.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <numeric>
#include <span>
#include <utility>

#include "box.hpp"
#include "columns.hpp"
#include "parallel.hpp"
#include "radix_sort.hpp"
#include "z_order.hpp"

namespace deburr {
namespace {

constexpr unsigned axis_bits = 10;
constexpr unsigned digits = (3 * axis_bits + radix_bits - 1) / radix_bits;

/// Either part of a split holds at least this share of the points, unless most are in one cell.
constexpr std::uint32_t fewest_share = 8;  // one in so many

/// Fewer keys are sorted by comparing.
constexpr std::size_t sorted_by_digits = 2048;

/// A key is the place of a cell along the curve and then the index of a point.
using Key = std::uint64_t;
constexpr unsigned index_bits = 32;

std::uint32_t index_of(Key key) { return static_cast<std::uint32_t>(key); }
std::uint32_t cell_of(Key key) { return static_cast<std::uint32_t>(key >> index_bits); }

class Layout {
 public:
  Layout(Points points, std::uint32_t most, const Execution& execution)
      : points_(points),
        most_(most),
        execution_(execution),
        keys_(make_column<Key>(points.size(), execution)) {
    const auto size = static_cast<std::uint32_t>(points.size());
    std::iota(keys_.begin(), keys_.end(), Key{0});
    sort(0, size);
    ranges_.reserve(4 * (points.size() / most) + 1);
    add(0, size);
  }

  TreeLayout take() && {
    TreeLayout layout;
    layout.order = make_column<std::uint32_t>(keys_.size(), execution_);
    parallel_for(keys_.size(), without_progress(execution_),
                 [&](std::size_t k) { layout.order[k] = index_of(keys_[k]); });
    layout.ranges = std::move(ranges_);
    return layout;
  }

 private:
  /// Sorts points by cells of the box around them.
  void sort(std::uint32_t begin, std::uint32_t end) {
    const std::span<Key> keys = std::span(keys_).subspan(begin, end - begin);
    Box box;
    for (const Key key : keys) box.add(points_[index_of(key)]);
    const Vec3 half = half_extent(box);
    const double largest = std::max({half.x, half.y, half.z});
    // Neither end of the box, where whole faces may lie, nor its middle is at the border of a cell.
    constexpr double first = 0.3;
    constexpr double cells = (1U << axis_bits) - 0.9;
    const auto cell = [&](double v, double from) {
      const double share = largest > 0 ? (0.5 * v - 0.5 * from) / largest : 0;
      return static_cast<std::uint64_t>(first + cells * std::min(share, 1.0));
    };
    const auto set = [&](std::size_t k) {
      const std::uint32_t i = index_of(keys[k]);
      const Vec3& p = points_[i];
      keys[k] = z_order(cell(p.x, box.low.x), cell(p.y, box.low.y), cell(p.z, box.low.z))
                    << index_bits |
                i;
    };
    if (keys.size() < sorted_by_digits) {
      for (std::size_t k = 0; k < keys.size(); ++k) set(k);
      std::ranges::sort(keys);
      return;
    }
    parallel_for(keys.size(), without_progress(execution_), set);
    if (!std::ranges::is_sorted(keys)) radix_sort<digits>(keys, scratch_, cell_of, execution_);
  }

  /// Adds the range and those of its descendants.
  void add(std::uint32_t begin, std::uint32_t end) {
    if (end - begin > block_size) check_cancelled(execution_);
    const std::size_t self = ranges_.size();
    ranges_.push_back({begin, end, 0});
    if (end - begin <= most_) return;
    const std::uint32_t middle = split(begin, end);
    add(begin, middle);
    ranges_[self].right = static_cast<std::uint32_t>(ranges_.size());
    add(middle, end);
  }

  std::uint32_t split(std::uint32_t begin, std::uint32_t end) {
    const std::uint32_t fewest = (end - begin) / fewest_share;
    const std::uint32_t low = begin + fewest;
    const std::uint32_t high = end - 1 - fewest;
    const std::uint32_t first = cell_of(keys_[low]);
    const std::uint32_t last = cell_of(keys_[high]);
    if (first != last) {
      // Where the two no longer share the larger cell of all.
      const auto bit = static_cast<unsigned>(std::bit_width(first ^ last)) - 1;
      return first_from(low + 1, high, last >> bit << bit);
    }
    const std::uint32_t from = first_from(begin, low, first);
    const std::uint32_t to = first_from(high, end, first + 1);
    if (from > begin || to < end) return from - begin >= end - to ? from : to;
    sort(begin, end);
    const bool apart = cell_of(keys_[begin]) != cell_of(keys_[end - 1]);
    return apart ? split(begin, end) : begin + (end - begin) / 2;
  }

  /// Place of the first key in a cell or beyond it; `end` if there is none before.
  [[nodiscard]] std::uint32_t first_from(std::uint32_t begin, std::uint32_t end,
                                         std::uint32_t cell) const {
    const auto at = std::ranges::lower_bound(keys_.begin() + begin, keys_.begin() + end, cell,
                                             std::less{}, cell_of);
    return static_cast<std::uint32_t>(at - keys_.begin());
  }

  Points points_;
  std::uint32_t most_;
  const Execution& execution_;
  std::vector<Key> keys_;
  std::vector<Key> scratch_;
  std::vector<TreeLayout::Range> ranges_;
};

}  // namespace

TreeLayout lay_out_tree(Points points, std::uint32_t most, const Execution& execution) {
  if (points.empty()) return {};
  return Layout(points, most, execution).take();
}

}  // namespace deburr

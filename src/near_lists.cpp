// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "near_lists.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "neighbor_search.hpp"
#include "parallel.hpp"

namespace deburr {
namespace {

constexpr std::size_t most_in_table = std::size_t{1} << 16;

DEBURR_MULTIVERSION
void look_up(const std::uint16_t* list, std::size_t count, const std::uint32_t* points,
             std::uint32_t* to) {
  for (std::size_t k = 0; k < count; ++k) to[k] = points[list[k]];
}

DEBURR_MULTIVERSION
void widen(const std::uint16_t* list, std::size_t count, std::uint32_t* to) {
  for (std::size_t k = 0; k < count; ++k) to[k] = list[k];
}

}  // namespace

/// Numbers points in the order that they come in.
class NearLists::Compressor {
 public:
  /// The lists of a block.
  void compress(std::span<const std::uint32_t> indices, Block& block) {
    keys_.assign(std::size_t{1} << 14, none);
    numbers_.resize(keys_.size());
    block.points.clear();
    block.lists.resize(indices.size());
    for (std::size_t k = 0; k < indices.size(); ++k) {
      const std::uint32_t number = number_of(indices[k], block.points);
      if (number >= most_in_table) {
        block.lists = {};
        block.points = {};
        block.wide.assign(indices.begin(), indices.end());
        return;
      }
      block.lists[k] = static_cast<std::uint16_t>(number);
    }
    block.points.shrink_to_fit();
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t number_of(std::uint32_t point, std::vector<std::uint32_t>& points) {
    const std::size_t slot = slot_of(point);
    if (keys_[slot] == point) return numbers_[slot];
    const auto number = static_cast<std::uint32_t>(points.size());
    keys_[slot] = point;
    numbers_[slot] = number;
    points.push_back(point);
    if (2 * points.size() > keys_.size()) grow(points);
    return number;
  }
  [[nodiscard]] std::size_t slot_of(std::uint32_t point) const {
    constexpr std::uint32_t golden = 0x9e3779b1U;  // spreads neighbours over the table
    const std::size_t mask = keys_.size() - 1;
    std::size_t slot = (point * golden >> 8U) & mask;
    while (keys_[slot] != none && keys_[slot] != point) slot = (slot + 1) & mask;
    return slot;
  }
  void grow(const std::vector<std::uint32_t>& points) {
    keys_.assign(2 * keys_.size(), none);
    numbers_.resize(keys_.size());
    for (std::uint32_t number = 0; number < points.size(); ++number) {
      const std::size_t slot = slot_of(points[number]);
      keys_[slot] = points[number];
      numbers_[slot] = number;
    }
  }

  std::vector<std::uint32_t> keys_;
  std::vector<std::uint32_t> numbers_;
};

/// @param find  find(begin, end, to) writes the lists of these points, one after the other
template <typename Find>
void NearLists::make_blocks(std::size_t count, const Find& find, const Execution& execution) {
  blocks_.resize((count + block_ - 1) / block_);
  parallel_blocks<1>(blocks_.size(), execution, [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t> indices;
    Compressor compressor;
    for (std::size_t b = first; b < last; ++b) {
      const std::size_t begin = b * block_;
      const std::size_t end = std::min(count, begin + block_);
      std::size_t pairs = 0;
      for (std::size_t i = begin; i < end; ++i) {
        lists_[i].begin = static_cast<std::uint32_t>(pairs);
        pairs += lists_[i].count;
      }
      indices.resize(pairs);
      for (std::size_t from = begin; from < end; from += block_size) {
        check_cancelled(execution);
        find(from, std::min(end, from + block_size), indices.data() + lists_[from].begin);
      }
      compressor.compress(indices, blocks_[b]);
    }
  });
}

NearLists::NearLists(Points points, double radius, std::uint32_t block, const Execution& execution)
    : block_(block), lists_(points.size()) {
  const NeighborSearch search(points, radius, execution);
  const std::vector<std::uint32_t> counts = search.count_all(execution);
  for (std::size_t i = 0; i < counts.size(); ++i) lists_[i].count = counts[i];
  make_blocks(
      points.size(),
      [&](std::size_t begin, std::size_t end, std::uint32_t* to) {
        search.find(begin, {counts.data() + begin, end - begin}, to);
      },
      execution);
}

NearLists::NearLists(const Neighborhoods& neighborhoods, std::uint32_t block,
                     const Execution& execution)
    : block_(block), lists_(neighborhoods.size()) {
  for (std::size_t i = 0; i < lists_.size(); ++i) {
    lists_[i].count = static_cast<std::uint32_t>(neighborhoods[i].size());
  }
  make_blocks(
      lists_.size(),
      [&](std::size_t begin, std::size_t end, std::uint32_t* to) {
        for (std::size_t i = begin; i < end; ++i) to = std::ranges::copy(neighborhoods[i], to).out;
      },
      execution);
}

std::span<const std::uint32_t> NearLists::read(std::size_t i,
                                               std::vector<std::uint32_t>& buffer) const {
  const List list = lists_[i];
  const Block& block = blocks_[i / block_];
  if (!block.wide.empty()) return {block.wide.data() + list.begin, list.count};
  if (buffer.size() < list.count) buffer.resize(2 * std::size_t{list.count});
  look_up(block.lists.data() + list.begin, list.count, block.points.data(), buffer.data());
  return {buffer.data(), list.count};
}

std::optional<std::span<const std::uint32_t>> NearLists::seen(std::size_t b) const {
  if (!blocks_[b].wide.empty()) return {};
  return blocks_[b].points;
}

std::span<const std::uint32_t> NearLists::read_seen(std::size_t i,
                                                    std::vector<std::uint32_t>& buffer) const {
  const List list = lists_[i];
  const Block& block = blocks_[i / block_];
  if (!block.wide.empty()) return {block.wide.data() + list.begin, list.count};
  if (buffer.size() < list.count) buffer.resize(2 * std::size_t{list.count});
  widen(block.lists.data() + list.begin, list.count, buffer.data());
  return {buffer.data(), list.count};
}

void NearLists::arrange(std::span<const std::uint32_t> order, const Execution& execution) {
  std::vector<std::uint32_t> rank(order.size());
  for (std::uint32_t at = 0; at < order.size(); ++at) rank[order[at]] = at;
  parallel_blocks<1>(blocks_.size(), execution, [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t> members;
    for (std::size_t b = first; b < last; ++b) {
      Block& block = blocks_[b];
      if (!block.wide.empty()) continue;
      const std::size_t begin = b * block_;
      members.resize(std::min<std::size_t>(lists_.size() - begin, block_));
      std::iota(members.begin(), members.end(), static_cast<std::uint32_t>(begin));
      std::ranges::sort(members, {}, [&](std::uint32_t i) { return rank[i]; });
      std::vector<std::uint16_t> arranged(block.lists.size());
      auto to = arranged.begin();
      for (const std::uint32_t i : members) {
        const auto from = block.lists.begin() + lists_[i].begin;
        lists_[i].begin = static_cast<std::uint32_t>(to - arranged.begin());
        to = std::copy_n(from, lists_[i].count, to);
      }
      block.lists = std::move(arranged);
    }
  });
}

}  // namespace deburr

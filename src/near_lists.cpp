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

/// Numbers the points that a block sees, near ones next to each other as they are in the cloud.
class NearLists::Compressor {
 public:
  explicit Compressor(std::size_t count) : numbers_(count, none) {}

  /// The lists of a block.
  void compress(std::span<const std::uint32_t> indices, Block& block) {
    seen_.clear();
    for (const std::uint32_t i : indices) {
      if (numbers_[i] != none) continue;
      numbers_[i] = 0;
      seen_.push_back(i);
    }
    if (seen_.size() <= most_in_table) {
      std::ranges::sort(seen_);
      for (std::uint32_t k = 0; k < seen_.size(); ++k) numbers_[seen_[k]] = k;
      block.points = seen_;
      block.lists.reserve(indices.size());
      for (const std::uint32_t i : indices) {
        block.lists.push_back(static_cast<std::uint16_t>(numbers_[i]));
      }
    } else {
      block.wide.assign(indices.begin(), indices.end());
    }
    for (const std::uint32_t i : seen_) numbers_[i] = none;
  }

 private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::vector<std::uint32_t> numbers_;  ///< of the points of the cloud that the block sees
  std::vector<std::uint32_t> seen_;
};

/// @param find  find(begin, end, to) writes the lists of these points, one after the other
template <typename Find>
void NearLists::make_blocks(std::size_t count, const Find& find, const Execution& execution) {
  blocks_.resize((count + block_ - 1) / block_);
  // To clear a number for each point of the cloud is little work next to that of several blocks.
  constexpr std::size_t at_a_time = 8;
  parallel_blocks<at_a_time>(blocks_.size(), execution, [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t> indices;
    Compressor compressor(count);
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

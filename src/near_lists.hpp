// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "deburr/execution.hpp"
#include "deburr/neighborhoods.hpp"
#include "lanes.hpp"

namespace deburr {

/// The neighbours of every point, as Neighborhoods has them, in half of the memory: points that
/// stand together have most of their neighbours in common, so that within a block of them a number
/// of 16 bits tells which one is meant. Found block by block: the full lists are never there.
class NearLists {
 public:
  /// Points of a block. What the sums over their neighbours read fits into the cache of a core.
  static constexpr std::uint32_t usual_block = 4096;

  NearLists() = default;
  /// All points within a radius. Points near to each other should have near indices.
  /// @throws DataError  as find_neighbors
  NearLists(Points points, double radius, std::uint32_t block, const Execution& execution);
  /// The same lists as those given.
  NearLists(const Neighborhoods& neighborhoods, std::uint32_t block, const Execution& execution);

  /// Number of points.
  [[nodiscard]] std::size_t size() const { return lists_.size(); }
  /// Points i and j are of one block if i / block() == j / block().
  [[nodiscard]] std::uint32_t block() const { return block_; }

  /// The neighbours of point i, sorted by (distance, index), in a buffer that is as large as
  /// needed.
  [[nodiscard]] std::span<const std::uint32_t> read(std::size_t i,
                                                    std::vector<std::uint32_t>& buffer) const;

  /// All neighbours of the points of block b; none where they are too many for 16 bits.
  [[nodiscard]] std::optional<std::span<const std::uint32_t>> seen(std::size_t b) const;
  /// As read(), but as indices into seen() where there is such a thing.
  [[nodiscard]] std::span<const std::uint32_t> read_seen(std::size_t i,
                                                         std::vector<std::uint32_t>& buffer) const;

  /// Has lists that are read in this order stand in it in memory, within each block.
  void arrange(std::span<const std::uint32_t> order, const Execution& execution);

 private:
  struct List {
    std::uint32_t begin, count;
  };
  struct Block {
    std::vector<std::uint32_t> points;  ///< all neighbours of its points
    std::vector<std::uint16_t> lists;   ///< indices into `points`
    std::vector<std::uint32_t> wide;    ///< the lists themselves, where they have too many points
  };

  class Compressor;
  template <typename Find>
  void make_blocks(std::size_t count, const Find& find, const Execution& execution);

  std::uint32_t block_ = usual_block;
  std::vector<List> lists_;
  std::vector<Block> blocks_;
};

/// The neighbours of up to eight points, read together.
class NearBatch {
 public:
  void read(const NearLists& lists, std::span<const std::uint32_t> points) {
    for (std::size_t l = 0; l < points.size(); ++l) lists_[l] = lists.read(points[l], buffers_[l]);
    std::fill(lists_.begin() + points.size(), lists_.end(), std::span<const std::uint32_t>{});
  }
  void read(const Neighborhoods& lists, std::span<const std::uint32_t> points) {
    for (std::size_t l = 0; l < points.size(); ++l) lists_[l] = lists[points[l]];
    std::fill(lists_.begin() + points.size(), lists_.end(), std::span<const std::uint32_t>{});
  }
  /// Those of `count` points from `first` on, as NearLists::read_seen.
  void read_seen(const NearLists& lists, std::size_t first, std::size_t count) {
    for (std::size_t l = 0; l < count; ++l) lists_[l] = lists.read_seen(first + l, buffers_[l]);
  }
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t l) const { return lists_[l]; }

 private:
  std::array<std::vector<std::uint32_t>, lane_count> buffers_;
  std::array<std::span<const std::uint32_t>, lane_count> lists_;
};

}  // namespace deburr

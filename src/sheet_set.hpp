// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kd_tree.hpp"
#include "packed_sheet.hpp"

namespace deburr {

/// Valid sheets of an even choice of the nodes, and then of further ones by edges.
struct NodeSheets {
  std::vector<PackedSheet> sheets;
  std::vector<std::uint32_t> nodes;  ///< that each is of, ascending in both parts
  std::size_t even = 0;              ///< sheets of the even choice
};

/// The sheets that points land on. Fits of neighbouring nodes share most of their points, so away
/// from edges an even choice of them says what all would.
class SheetSet {
 public:
  static constexpr std::uint32_t none = KdTree::no_point;

  /// @param nodes  number of all nodes
  SheetSet(NodeSheets fitted, std::size_t nodes, const Execution& execution = {});

  // The trees look at the places: a copy would look at those of another.
  SheetSet(const SheetSet&) = delete;
  SheetSet& operator=(const SheetSet&) = delete;
  ~SheetSet() = default;

  [[nodiscard]] std::span<const PackedSheet> sheets() const { return sheets_; }
  /// Of the places of the even choice, which are the first of sheets().
  [[nodiscard]] const KdTree& even() const { return even_; }
  /// Of the places of all sheets.
  [[nodiscard]] const KdTree& all() const {
    return sheets_.size() > even_.order().size() ? all_ : even_;
  }
  /// The sheet of a node, or `none`.
  [[nodiscard]] std::uint32_t of(std::uint32_t node) const { return of_[node]; }

 private:
  std::vector<PackedSheet> sheets_;
  std::vector<std::uint32_t> of_;
  std::vector<Vec3> places_;
  KdTree even_;
  KdTree all_;
};

}  // namespace deburr

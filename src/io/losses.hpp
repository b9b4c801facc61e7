// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/colors.hpp"
#include "io/fields.hpp"

namespace deburr {

/// Collects, one sentence each, what a format could not hold.
class Losses {
 public:
  explicit Losses(std::string_view format) : format_(format) {}

  void add(std::string sentence) { sentences_.push_back(std::move(sentence)); }
  /// An attribute that was left out.
  void add(const Attribute& attribute);
  /// That an attribute was written under another name, if it was.
  void add_renamed(const Column& column);
  /// An element that was left out.
  void add(const Element& element);
  /// All elements, but for these attributes of theirs.
  void add_elements(const FileLayout& layout, const std::vector<const Attribute*>& kept = {});
  /// Those blocks of the layout that belong to other formats than the one with this prefix.
  void add_foreign_blocks(const FileLayout& layout, std::string_view own_prefix);
  /// Comments of which a character became a blank, if there are any.
  void add_changed_comments(std::size_t count);
  /// An alpha of eight bits beside colours of 16, where all get the same.
  void add_wider_alpha(const Colors& colors);
  /// A name that became another.
  void add_name(std::string_view before, std::string_view after);
  /// Comments and obj_info.
  void add_comments(const FileLayout& layout);
  /// Coordinates that are rounded to 32-bit floats and too large for them: coarse_float_step().
  void add_coarse_floats(Points points);

  [[nodiscard]] std::vector<std::string> take() { return std::move(sentences_); }

 private:
  std::string format_;
  std::vector<std::string> sentences_;
};

/// The step of 32-bit floats at the largest finite coordinate, where it is more than 1e-5 of the
/// diagonal of the bounding box; else 0. Survey coordinates far from the origin are such a case.
[[nodiscard]] double coarse_float_step(Points points);

}  // namespace deburr

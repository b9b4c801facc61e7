// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/losses.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/comments.hpp"

namespace deburr {
namespace {

std::string_view kind_of(const Attribute& attribute) {
  if (attribute.type() == ScalarType::Text) return "text";
  if (attribute.is_list()) return "lists";
  return attribute.type() <= ScalarType::UInt64 ? "integers" : "numbers";
}

}  // namespace

void Losses::add(const Attribute& attribute) {
  const std::string_view kind = kind_of(attribute);
  add(fmt::format("{} cannot hold the {} '{}', which {} left out", format_, kind, attribute.name,
                  kind == "text" ? "was" : "were"));
}

void Losses::add_renamed(const Column& column) {
  if (column.attribute == nullptr || column.attribute->name == column.name) return;
  add(fmt::format("the field '{}' was written as '{}', since the normals have its name",
                  column.attribute->name, column.name));
}

void Losses::add(const Element& element) {
  add(fmt::format("{} cannot hold the element '{}' ({} items), which was left out", format_,
                  element.name, element.size));
}

void Losses::add_elements(const FileLayout& layout, const std::vector<const Attribute*>& kept) {
  for (const Element& element : layout.elements) {
    const auto is_kept = [&](const Attribute& a) {
      return std::ranges::find(kept, &a) != kept.end();
    };
    if (std::ranges::none_of(element.attributes, is_kept)) {
      add(element);
      continue;
    }
    for (const Attribute& a : element.attributes) {
      if (is_kept(a)) continue;
      add(fmt::format("{} cannot hold '{}' of the element '{}', which was left out", format_,
                      a.name, element.name));
    }
  }
}

void Losses::add_foreign_blocks(const FileLayout& layout, std::string_view own_prefix) {
  std::vector<std::string_view> names;
  for (const HeaderBlock& block : layout.blocks) {
    if (block.name.starts_with(own_prefix) || is_block_of_marks(block)) continue;
    names.push_back(block.name);
  }
  if (names.empty()) return;
  add(fmt::format("{} cannot hold: {}; left out", format_, fmt::join(names, ", ")));
}

void Losses::add_changed_comments(std::size_t count) {
  if (count == 0) return;
  add(
      fmt::format("{} cannot hold the control characters in comments ({} of them), which became "
                  "blanks",
                  format_, count));
}

void Losses::add_wider_alpha(const Colors& colors) {
  if (colors.of[3] == nullptr || colors.most[3] == colors.most[0]) return;
  add(fmt::format(
      "{} holds 'alpha' in as many bits as the colours, which makes other numbers of it", format_));
}

void Losses::add_name(std::string_view before, std::string_view after) {
  if (before == after) return;
  add(fmt::format("{} cannot hold the name '{}', it became '{}'", format_, before, after));
}

void Losses::add_comments(const FileLayout& layout) {
  const std::size_t count = layout.comments.size() + layout.obj_info.size();
  if (count == 0) return;
  add(fmt::format("{} cannot hold comments, {} left out", format_, count));
}

void Losses::add_coarse_floats(Points points) {
  const double step = coarse_float_step(points);
  if (step == 0) return;
  const auto is_float = [](double value) {
    return std::isnan(value) || static_cast<double>(static_cast<float>(value)) == value;
  };
  const bool are_exact = std::ranges::all_of(
      points, [&](const Vec3& p) { return is_float(p.x) && is_float(p.y) && is_float(p.z); });
  if (are_exact) return;
  add(fmt::format(
      "{} was written with 32-bit floats, which are {:.2g} apart at coordinates as large as these",
      format_, step));
}

double coarse_float_step(Points points) {
  constexpr double coarse = 1e-5;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low{infinity, infinity, infinity};
  Vec3 high{-infinity, -infinity, -infinity};
  double largest = 0;
  for (const Vec3& p : points) {
    if (!is_finite(p)) continue;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  const double diagonal = norm(high - low);
  if (!std::isfinite(diagonal) || !(diagonal > 0)) return 0;
  const double step = std::ldexp(1.0, std::ilogb(largest) - 23);
  return step > coarse * diagonal ? step : 0;
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "io/pcd_plan.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/lines.hpp"
#include "io/numbers.hpp"
#include "io/scalar_type.hpp"

namespace deburr {
namespace {

/// Of a coordinate.
std::string name_of(const Column& c, bool is_pcd_layout) {
  constexpr std::array names{"x", "y", "z", "normal_x", "normal_y", "normal_z"};
  return is_pcd_layout && c.in_layout ? c.name : names.at(static_cast<std::size_t>(c.role));
}

bool is_pcd(Encoding encoding) {
  return encoding == Encoding::PcdAscii || encoding == Encoding::PcdBinary ||
         encoding == Encoding::PcdCompressed;
}

const std::string* find_block(const FileLayout& layout, std::string_view name) {
  const auto found = std::ranges::find(layout.blocks, name, &HeaderBlock::name);
  return found == layout.blocks.end() ? nullptr : &found->data;
}

}  // namespace

PcdPlan::PcdPlan(const PointCloud& cloud, const std::vector<Column>& columns, Losses& losses)
    : cloud_(cloud), losses_(losses) {
  const FileLayout& layout = cloud.layout;
  const bool is_pcd_layout = is_pcd(layout.encoding);
  header.encoding = is_pcd_layout ? layout.encoding : Encoding::PcdBinary;
  header.width = cloud.size();
  if (const std::string* text = find_block(layout, "PCD viewpoint")) header.viewpoint = *text;
  if (const std::string* text = find_block(layout, "PCD rows")) keep_rows(*text);
  take_colors(is_pcd_layout);
  // Normals that are new have the type of the coordinates: PCL reads both as floats only.
  const auto x = std::ranges::find(columns, 0, &Column::role);
  for (const Column& c : columns) {
    if (c.role != no_role) names_.insert(name_of(c, is_pcd_layout));
  }
  for (const Column& c : columns) {
    if (c.role != no_role) {
      add_coordinate(c, is_pcd_layout, c.in_layout || c.role < 3 ? c.type : x->type);
    } else {
      add_attribute(c);
    }
  }
  losses_.add_elements(layout);
  losses_.add_foreign_blocks(layout, "PCD ");
  if (x->type == ScalarType::Float32 && header.encoding != Encoding::PcdAscii) {
    losses_.add_coarse_floats(cloud.points);
  }
}

/// The rows of an organised cloud are lost with the first point that is removed.
void PcdPlan::keep_rows(const std::string& text) {
  const std::size_t rows = parse_number<std::size_t>(text).value_or(0);
  if (rows == 0 || cloud_.size() % rows != 0) return;
  header.height = rows;
  header.width = cloud_.size() / rows;
}

void PcdPlan::take_colors(bool is_pcd_layout) {
  const std::string* const name = find_block(cloud_.layout, "PCD colour");
  if (is_pcd_layout && name == nullptr) return;  // separate fields stay separate
  colors = find_colors(cloud_);
  if (!colors.are_integers()) colors = {};
  color_name_ = name != nullptr ? *name : colors.of[3] != nullptr ? "rgba" : "rgb";
}

void PcdPlan::add(const std::string& wanted, ScalarType type, std::size_t count, PcdSource source) {
  std::string name = wanted;
  std::ranges::replace_if(
      name, [](char c) { return c == '\n' || is_blank(c); }, '_');
  // The name of a field of padding.
  if (name.empty() || name == "_") name = "field";
  while (source.coordinate == nullptr && !names_.insert(name).second) name += '_';
  losses_.add_name(wanted, name);
  header.fields.push_back({name, type, count, header.point_bytes});
  header.point_bytes += size_of(type) * count;
  sources.push_back(source);
}

void PcdPlan::add_coordinate(const Column& c, bool is_pcd_layout, ScalarType wish) {
  const bool is_real = wish == ScalarType::Float32 || wish == ScalarType::Float64;
  add(name_of(c, is_pcd_layout), is_real ? wish : ScalarType::Float64, 1, {&c, nullptr});
}

void PcdPlan::add_attribute(const Column& column) {
  const Attribute& attribute = *column.attribute;
  if (std::ranges::find(colors.of, &attribute) != colors.of.end()) {
    if (&attribute == colors.of[0]) add(color_name_, ScalarType::UInt32, 1, {});
    constexpr unsigned byte = 255;
    if (colors.most[0] <= byte) return;
  }
  std::size_t count = 1;
  if (attribute.is_list()) {
    count = cloud_.size() > 0 ? attribute.offsets[1] : 2;
    for (std::size_t i = 0; i < cloud_.size(); ++i) {
      if (attribute.offsets[i + 1] != (i + 1) * count) count = 0;
    }
  }
  if (attribute.type() == ScalarType::Text || count == 0) return losses_.add(attribute);
  losses_.add_renamed(column);
  add(column.name, attribute.type(), count, {nullptr, &attribute});
}

}  // namespace deburr

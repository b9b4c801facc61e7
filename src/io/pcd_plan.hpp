// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "io/colors.hpp"
#include "io/fields.hpp"
#include "io/losses.hpp"
#include "io/pcd_header.hpp"

namespace deburr {

/// Where the values of a field come from.
struct PcdSource {
  const Column* coordinate = nullptr;
  const Attribute* attribute = nullptr;  ///< or, if this is null as well, the colours
};

/// The header of the file that a cloud is written to, and where its values come from.
///
/// Colours are packed into one field, as programs of PCL want them. If they have 16 bits, they
/// stand in fields of their own behind it as well, so that nothing is lost.
class PcdPlan {
 public:
  /// @param columns  those of the cloud; both have to outlive the plan
  PcdPlan(const PointCloud& cloud, const std::vector<Column>& columns, Losses& losses);

  PcdHeader header;
  std::vector<PcdSource> sources;  ///< of each field
  Colors colors;                   ///< those that are packed

 private:
  void keep_rows(const std::string& text);
  void take_colors(bool is_pcd_layout);
  void add(const std::string& wanted, ScalarType type, std::size_t count, PcdSource source);
  void add_coordinate(const Column& c, bool is_pcd_layout, ScalarType wish);
  void add_attribute(const Column& column);

  const PointCloud& cloud_;
  Losses& losses_;
  std::string color_name_;
  std::set<std::string> names_;
};

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "io/las_extra.hpp"
#include "io/las_fields.hpp"
#include "io/las_header.hpp"

// What a reader of LAS says beside the values: names of columns, records, comments.

namespace deburr {

/// Gives every attribute a name of its own. Extra bytes can have any name, also one that is taken:
/// if they have that of a field of the format that is 0 everywhere, the field is what goes, since a
/// writer puts its zeros back.
/// @param roles  of the extras; those with a role are no attributes
void name_las_columns(PointCloud& cloud, const std::vector<LasExtra>& extras,
                      const std::vector<int>& roles);

/// The layout of a cloud whose columns have their names.
[[nodiscard]] FileLayout las_layout(const PointCloud& cloud, const LasHeader& header,
                                    const std::vector<LasExtra>& extras,
                                    const std::vector<int>& roles);

/// Names of those fields of the format that name_las_columns() left out for extra ones. The layout
/// has the others first and then the extra ones, which may have their names.
[[nodiscard]] std::set<std::string_view> replaced_las_fields(const FileLayout& layout,
                                                             const std::vector<LasField>& fields,
                                                             const std::vector<LasExtra>& extras);

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

#include "deburr/point_cloud.hpp"
#include "support/same_values.hpp"

namespace deburr {

inline void expect_same(const std::vector<Attribute>& a, const std::vector<Attribute>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    SCOPED_TRACE(a[k].name);
    EXPECT_EQ(a[k].name, b[k].name);
    EXPECT_EQ(a[k].offsets, b[k].offsets);
    if (a[k].is_list()) {
      EXPECT_EQ(a[k].length_type, b[k].length_type);
    }
    ASSERT_EQ(a[k].type(), b[k].type());
    std::visit(
        [&](const auto& values) {
          using Vector = std::remove_cvref_t<decltype(values)>;
          EXPECT_TRUE(same_values(values, std::get<Vector>(b[k].values)));
        },
        a[k].values);
  }
}

/// Compares all that a cloud says, to the last bit.
inline void expect_same(const PointCloud& a, const PointCloud& b) {
  EXPECT_TRUE(same_values(a.points, b.points));
  EXPECT_TRUE(same_values(a.normals, b.normals));
  expect_same(a.attributes, b.attributes);
  EXPECT_EQ(a.layout.encoding, b.layout.encoding);
  EXPECT_EQ(a.layout.fields, b.layout.fields);
  EXPECT_EQ(a.layout.comments, b.layout.comments);
  EXPECT_EQ(a.layout.obj_info, b.layout.obj_info);
  EXPECT_EQ(a.layout.text.separator, b.layout.text.separator);
  EXPECT_EQ(a.layout.text.header, b.layout.text.header);
  EXPECT_EQ(a.layout.text.mark, b.layout.text.mark);
  EXPECT_EQ(a.layout.text.count_line, b.layout.text.count_line);
  ASSERT_EQ(a.layout.elements.size(), b.layout.elements.size());
  for (std::size_t k = 0; k < a.layout.elements.size(); ++k) {
    EXPECT_EQ(a.layout.elements[k].name, b.layout.elements[k].name);
    EXPECT_EQ(a.layout.elements[k].size, b.layout.elements[k].size);
    EXPECT_EQ(a.layout.elements[k].before_points, b.layout.elements[k].before_points);
    expect_same(a.layout.elements[k].attributes, b.layout.elements[k].attributes);
  }
}

}  // namespace deburr

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "deburr/io.hpp"
#include "io/format.hpp"
#include "support/find_attribute.hpp"
#include "support/temp_dir.hpp"

namespace deburr {

/// The cloud in a file with this content.
inline PointCloud parsed(const std::string& data, std::string_view format = {}) {
  return parse_cloud({"given", data, {}}, format);
}

/// The content of the file that a cloud is written to.
inline std::string written_as(const TempDir& dir, const PointCloud& cloud, const std::string& name,
                              std::vector<std::string>* warnings = nullptr) {
  const std::vector<std::string> said = write_cloud(dir / name, cloud);
  if (warnings != nullptr) *warnings = said;
  return get(dir / name);
}

inline std::vector<std::string> field_names(const PointCloud& cloud) {
  std::vector<std::string> names;
  for (const Field& field : cloud.layout.fields) names.push_back(field.name);
  return names;
}

/// The values of an attribute; empty if it is not there or has another type.
template <typename T>
std::vector<T> values_of(const PointCloud& cloud, const std::string& name) {
  const Attribute* const attribute = find_attribute(cloud, name);
  if (attribute == nullptr) return {};
  const auto* const values = std::get_if<std::vector<T>>(&attribute->values);
  return values != nullptr ? *values : std::vector<T>{};
}

}  // namespace deburr

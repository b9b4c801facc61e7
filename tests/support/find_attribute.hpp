// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>

#include "deburr/point_cloud.hpp"

namespace deburr {

/// The attribute with this name, or null.
inline const Attribute* find_attribute(const PointCloud& cloud, const std::string& name) {
  const auto found = std::ranges::find(cloud.attributes, name, &Attribute::name);
  return found != cloud.attributes.end() ? &*found : nullptr;
}

}  // namespace deburr

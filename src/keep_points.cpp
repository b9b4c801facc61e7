// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "keep_points.hpp"

#include <span>
#include <utility>

namespace deburr {
namespace {

using Mask = std::span<const std::uint8_t>;  ///< 1 for what goes

template <typename Value>
void erase_marked(std::vector<Value>& values, Mask mask) {
  std::size_t to = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (mask[i] != 0) continue;
    if (to != i) values[to] = std::move(values[i]);
    ++to;
  }
  values.resize(to);
}

void erase_marked(Attribute& attribute, Mask mask) {
  std::visit(
      [&](auto& values) {
        if (!attribute.is_list()) {
          erase_marked(values, mask);
          return;
        }
        std::vector<std::size_t> offsets{0};
        std::size_t to = 0;
        for (std::size_t i = 0; i < mask.size(); ++i) {
          if (mask[i] != 0) continue;
          for (std::size_t k = attribute.offsets[i]; k < attribute.offsets[i + 1]; ++k, ++to) {
            if (to != k) values[to] = std::move(values[k]);
          }
          offsets.push_back(to);
        }
        values.resize(to);
        attribute.offsets = std::move(offsets);
      },
      attribute.values);
}

}  // namespace

void remove_outliers(DenoiseResult& result) {
  const std::vector<std::uint8_t> mask = std::exchange(result.outliers, {});
  PointCloud& cloud = result.cloud;
  erase_marked(cloud.points, mask);
  if (!cloud.normals.empty()) erase_marked(cloud.normals, mask);
  for (Attribute& attribute : cloud.attributes) erase_marked(attribute, mask);
  cloud.layout.elements.clear();
  erase_marked(result.labels, mask);
  erase_marked(result.displacement, mask);
  result.outliers.assign(cloud.size(), 0);
}

}  // namespace deburr

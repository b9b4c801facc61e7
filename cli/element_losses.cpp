// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "element_losses.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace deburr::cli {

std::vector<ElementSize> element_sizes(const PointCloud& cloud) {
  std::vector<ElementSize> sizes;
  sizes.reserve(cloud.layout.elements.size());
  for (const Element& e : cloud.layout.elements) sizes.emplace_back(e.name, e.size);
  return sizes;
}

void warn_of_lost_elements(const std::string& input, const std::vector<ElementSize>& before,
                           const std::vector<ElementSize>& after,
                           std::vector<std::string>& warnings) {
  for (const auto& [name, size] : before) {
    const auto found = std::ranges::find(after, name, &ElementSize::first);
    if (found == after.end()) {
      warnings.push_back(
          fmt::format("{}: {} left out, which may refer to points that are removed", input, name));
    } else if (found->second < size) {
      warnings.push_back(fmt::format("{}: {} of {} items of '{}' left out with their points", input,
                                     size - found->second, size, name));
    }
  }
}

}  // namespace deburr::cli

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include "some_points.hpp"

#include <algorithm>

namespace deburr {

std::vector<std::uint32_t> SomePoints::groups(std::size_t most) const {
  std::vector<std::uint32_t> begins = tree_.groups(most);
  if (places_.empty()) return begins;
  std::uint32_t kept = 0;
  std::uint32_t at = 0;
  for (std::uint32_t& begin : begins) {
    for (; at < begin; ++at) kept += places_[tree_.order()[at]] == none ? 0 : 1;
    begin = kept;
  }
  begins.erase(std::unique(begins.begin(), begins.end()), begins.end());
  return begins;
}

void SomePoints::nearest_to(const Vec3& at, std::size_t count, std::vector<Found>& found) const {
  constexpr double no_limit = std::numeric_limits<double>::infinity();
  if (places_.empty()) return tree_.nearest_to(at, count, no_limit, found);
  for (std::size_t ask = count + 2;; ask *= 2) {
    tree_.nearest_to(at, ask, no_limit, found);
    const bool all = ask >= tree_.order().size();
    std::size_t kept = 0;
    for (const Found& f : found) {
      const std::uint32_t here = places_[f.index];
      if (here != none && kept < count) found[kept++] = {f.squared_distance, here};
    }
    found.resize(kept);
    if (all || kept == count) return;
  }
}

}  // namespace deburr

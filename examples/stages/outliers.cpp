// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  std::vector<deburr::Vec3> points = deburr::synthesize_part({.points = 20000}).cloud.points;
  points.push_back({50, 30, 60});  // 20 mm above the top of the part
  // A dense clump of 27 points beside it.
  for (int i = 0; i < 27; ++i) {
    const int row = i / 3 % 3;
    const int layer = i / 9;
    points.push_back({120 + 0.5 * (i % 3), 30 + 0.5 * row, 20 + 0.5 * layer});
  }
  const std::vector<std::uint8_t> outlier = deburr::find_outliers(points);
  std::printf("%td of 28 found, %td of the part flagged\n",
              std::count(outlier.begin() + 20000, outlier.end(), 1),
              std::count(outlier.begin(), outlier.begin() + 20000, 1));
}

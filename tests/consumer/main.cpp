// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <deburr/deburr.hpp>

namespace {

double mean_height(const std::vector<deburr::Vec3>& points) {
  double sum = 0;
  for (const deburr::Vec3& p : points) sum += std::abs(p.z);
  return sum / static_cast<double>(points.size());
}

}  // namespace

// A square plate at z = 0, its points a little above and below.
int main() {
  constexpr int side = 40;
  deburr::PointCloud plate;
  for (int i = 0; i < side * side; ++i) {
    const double noise = 0.2 * std::sin(12.9898 * i);
    plate.points.push_back({static_cast<double>(i % side), static_cast<double>(i / side), noise});
  }
  const deburr::DenoiseResult result = deburr::denoise(plate);
  const double before = mean_height(plate.points);
  const double after = mean_height(result.cloud.points);
  std::printf("deburr %s: mean height %.3f before, %.3f after\n", deburr::version, before, after);
  return result.cloud.size() == plate.size() && after < before / 2 ? 0 : 1;
}

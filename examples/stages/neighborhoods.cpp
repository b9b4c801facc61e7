// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  const deburr::PointCloud cloud = deburr::synthesize_part({.points = 20000}).cloud;
  const auto nearest = deburr::find_neighbors(cloud.points, {.max_count = 12});
  const double dbar = deburr::mean_neighbor_distance(cloud.points, nearest);
  const auto ball = deburr::find_neighbors(cloud.points, {.radius = 2 * dbar});
  const double mean = static_cast<double>(ball.pair_count()) / static_cast<double>(ball.size());
  std::printf("dbar %.1f mm, %.0f neighbours within 2 dbar\n", dbar, mean);
}

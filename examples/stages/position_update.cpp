// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  // Four points of the plane z = 0 and one above it.
  const std::vector<deburr::Vec3> p{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 0.4}};
  const std::vector<deburr::Vec3> normals(5, {0, 0, 1});
  const deburr::FeatureField flat{std::vector(5, deburr::Feature::Surface),
                                  std::vector<deburr::Vec3>(5)};
  const auto all = deburr::find_neighbors(p, {.max_count = 4});
  const deburr::PositionUpdateOptions options{.position_scale = 1, .step = 0.5, .max_move = 1};
  const auto moved = deburr::update_positions(p, p, normals, flat, all, options);
  std::printf("z 0.40, then %.2f\n", moved[4].z);
}

// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  const std::vector<deburr::Vec3> square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const auto nearest = deburr::find_neighbors(square, {.max_count = 3});
  const auto first = deburr::estimate_normals(square, nearest);
  std::printf("estimated |z|: %.2f\n", std::abs(first[0].z));

  const std::vector<deburr::Vec3> tilted(4, {0.6, 0, 0.8});
  const auto again = deburr::refit_normals(square, tilted, nearest, {.position_scale = 1});
  std::printf("z of a tilted normal: 0.80, refitted: %.2f\n", again[0].z);
}

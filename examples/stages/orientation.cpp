// SPDX-FileCopyrightText: 2026 The deburr authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <deburr/deburr.hpp>

int main() {
  const std::vector<deburr::Vec3> square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<deburr::Vec3> mixed{{0, 0, 1}, {0, 0, -1}, {0, 0, -1}, {0, 0, 1}};
  const auto nearest = deburr::find_neighbors(square, {.max_count = 3});
  for (const deburr::Vec3& n : deburr::orient_normals(square, mixed, nearest)) {
    std::printf("%g\n", n.z);
  }
}
